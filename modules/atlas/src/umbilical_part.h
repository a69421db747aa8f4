// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "glisson/core/frames.h"
#include "glisson/patient/patient_model.h"

namespace glisson::atlas {

/// The umbilical part of the portal vein's left branch: it runs forwards in the umbilical fissure and ends
/// where the round ligament begins (Rex's recess).
struct UmbilicalPart {
  Point<CtFrame> base, tip;
  double radius = 0.0;  ///< mean over the two centimetres by which it was told, metres
};

/// Where segmented portal veins show it (README: "Umbilical fissure"): a thick stretch that runs forwards
/// after the vein has run up and to the left. Neither the roots, the order of nodes nor the direction of
/// beams count. Empty: none of them shows it.
/// @param trees of portal veins @param upright turns the CT's frame into the atlas' (axes to the patient's
/// left, back and head)
std::optional<UmbilicalPart> umbilical_part(const std::vector<VesselTree>& trees,
                                            const Eigen::Matrix3d& upright);

}  // namespace glisson::atlas
