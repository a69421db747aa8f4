// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "glisson/insilico/pathology.h"

/// @file
/// A real CT with its expert's labels, altered in a known way: tumours put into it, thicker slices, more
/// noise. Its anatomy, neighbours and texture stay real, so that it stands between a synthetic CT and that of
/// one more patient. Places are drawn by seed.

namespace glisson::insilico {

/// One way in which a CT is altered. By default nothing is.
struct Alteration {
  std::string name;
  std::vector<LesionKind> lesions;   ///< hypodense, necrotic or cyst
  double lesion_contrast_hu = 45.0;  ///< by which a hypodense one is darker than this liver
  int slices_joined = 1;             ///< thick slices are means of so many
  double noise_hu = 0.0;             ///< added; standard deviation
};

/// Of the kinds that other hospitals' CTs were found to differ by.
std::vector<Alteration> alterations();

/// The altered CT and its truth. A tumour replaces the local mean and keeps the CT's own noise; its edge is
/// as soft as the scanner's (1 mm); what bulges out of the organ (3 mm at most) replaces soft tissue alone.
/// @param truth the expert's labels, on the CT's grid. @throws InputError when it holds no parenchyma, or no
/// place for a lesion. Empty: cancelled.
Cancellable<PathologyCt> altered_ct(const Image& ct, const LabelMap& truth, const Alteration& alteration,
                                    std::uint64_t seed, const RunContext& context);

}  // namespace glisson::insilico
