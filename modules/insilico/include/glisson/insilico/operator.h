// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "glisson/editing/edit.h"
#include "glisson/insilico/theatre.h"
#include "glisson/patient/label_map.h"
#include "glisson/patient/patient_model.h"
#include "glisson/segmentation/segment.h"
#include "glisson/stereo/regions.h"

namespace glisson::insilico {

/// A simulated operator: knows the truth, writes what a person would click, with click noise. Stages read
/// only its files.
struct OperatorOptions {
  double click_noise_mm = 1.5;  ///< in the CT, standard deviation a coordinate
  double click_noise_px = 3.0;  ///< on the screen, standard deviation a coordinate
  bool click_margin = false;    ///< the anterior margin too (otherwise the model stage detects it)
  std::uint64_t seed = 1;
  /// @throws InputError naming the option.
  void validate() const;
};

/// What a person clicks in the CT, knowing the anatomy: several points deep in the liver, the thick ends of
/// the vessel trees, the middle of the vena cava, the gallbladder and every lesion, some points beside the
/// liver. A click that noise carries off its structure is made again, as a person who sees it would.
/// @throws InputError when the map holds no liver.
segmentation::Seeds click_seeds(const LabelMap& truth, const OperatorOptions& options);
/// How a person mends portal and hepatic veins in the liver: up to `count` strokes of a ball brush along a
/// line in one slice each (2 mm between places, a third of the click noise), where most is wrong (missing, or
/// too much) after the strokes before.
/// @pre one grid, count >= 0. @throws InputError when the truth holds no liver.
std::vector<editing::Edit> draw_vessel_strokes(const LabelMap& labels, const LabelMap& truth, int count,
                                               const OperatorOptions& options);
/// Notch and vena cava points, displaced by the noise; the margin as some fifteen clicks along it if asked
/// for.
Landmarks click_landmarks(const Landmarks& truth, const OperatorOptions& options);
/// Polygons of 20 to 40 corners on the left picture of a frame: the liver slightly inside its outline, a band
/// along the visible margin, the surroundings of the notch. Empty regions are left out.
stereo::Regions click_regions(const Theatre& theatre, int frame, const OperatorOptions& options);

}  // namespace glisson::insilico
