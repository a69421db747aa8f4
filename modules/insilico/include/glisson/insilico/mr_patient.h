// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "glisson/core/run_context.h"
#include "glisson/patient/label_map.h"
#include "glisson/volume/image.h"

namespace glisson::insilico {

/// What is varied of the synthetic patient's MRI.
struct MrOptions {
  /// Fat-suppressed T1 gradient echo 70 s after gadolinium and without it; fat-suppressed T2 spin echo, in
  /// which flowing blood is black.
  enum class Sequence { t1_venous, t1_unenhanced, t2 };
  std::uint64_t shape_seed = 1;               ///< the patient of make_patient() with the same seed
  Eigen::Vector3d spacing_mm{1.5, 1.5, 3.0};  ///< slices are the mean over their thickness
  Sequence sequence = Sequence::t1_venous;
  double coil_variation = 0.3;  ///< the coils' sensitivity lies within 1 -+ this
  double liver_snr = 25.0;      ///< mean of the liver over the standard deviation of either channel
  /// @throws InputError naming the field that is out of its range.
  void validate() const;
};

/// An MRI whose truth is known.
struct MrPatient {
  Image mr;
  LabelMap truth;  ///< on the MRI's grid
};

/// Draws the patient and scans it: signals of the tissues (see mr_signal.h), mixed where a surface cuts a
/// voxel; a smooth coil field; the magnitude of two noisy channels (Rician: Gudbjartsson and Patz 1995). The
/// same options give the same bits. Limits: no motion, no arteries in the liver, no chemical shift, fat
/// suppressed alike everywhere. Empty: cancelled. @throws InputError options.
Cancellable<MrPatient> make_mr_patient(const MrOptions& options, const RunContext& context);

}  // namespace glisson::insilico
