// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "glisson/atlas/atlas.h"
#include "glisson/core/json_file.h"
#include "glisson/core/run_context.h"
#include "glisson/experiments/aims.h"

/// @file
/// The atlas, measured: on livers of the synthetic population, whose landmarks are known by formula, and on
/// real livers whose labels show vena cava, portal vein and gallbladder, and on which two readers have marked
/// notch, falciform line and margin; and what its landmarks are worth to a registration (in silico).

namespace glisson::experiments {

/// What is measured.
struct AtlasProofOptions {
  std::filesystem::path data;                    ///< with liver_labelmaps; absent: in silico only
  std::shared_ptr<const atlas::Atlas> built_in;  ///< what comes with the program
  /// What two readers marked on the label maps (readings.h); not there: notch, falciform line and margin of
  /// the real livers are not known.
  std::filesystem::path readings;
  bool synthetic = true;    ///< in silico too
  int livers = 10;          ///< of the synthetic population
  int effect_patients = 2;  ///< who are registered with landmarks of each source; 0: none
  bool validation = true;   ///< the label maps with odd numbers too
  std::uint64_t seed = 1;

  /// @throws InputError there is no built-in atlas; naming the option.
  void validate() const;
};

/// What was measured of the landmarks that an atlas foretells.
struct AtlasProof {
  /// Keys begin with "synthetic_" (in silico), "real_" (each real liver by all others; "real_even_" for those
  /// that served development, "real_odd_" for validation), "built_in_" (real livers by the built-in atlas),
  /// "with_vein_" (the same with the portal vein as evidence of notch and falciform line),
  /// "with_notch_" (the same with the readers' notch as a person's mark; of the notch itself nothing),
  /// "readings_" (how far the two readers lie apart), "effect_" (landmark_effect.h, in silico).
  Figures figures;
  std::vector<std::string> absent;  ///< real data that were left out
  /// A row a source of landmarks, then a row a real liver, then what the build of these told
  /// ("atlas.outlier").
  std::vector<std::string> table;
};
const std::vector<Aim>& atlas_aims();

/// Empty: cancelled. @throws InputError options; Error of any stage.
Cancellable<AtlasProof> prove_atlas(const AtlasProofOptions& options, const RunContext& context);

}  // namespace glisson::experiments
