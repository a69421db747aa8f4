// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glisson/atlas/transfer.h"

namespace glisson::atlas {

/// Draws notch and falciform line to the umbilical fissure where the portal vein shows it (README: "Umbilical
/// fissure"); what is not from statistics alone stays. Where it does not show it, or shows it where it cannot
/// be, nothing is drawn and a doubt says so.
/// @param proposals of all structures, with what the image and a person show of them. @param foretold the
/// same from statistics alone. @param portal_vein its trees, CT frame, metres. @param upright turns the CT's
/// frame into the atlas' (axes to the patient's left, back and head).
void draw_to_fissure(std::vector<Proposal>& proposals, const std::vector<Proposal>& foretold,
                     const std::vector<VesselTree>& portal_vein, const Eigen::Matrix3d& upright,
                     std::vector<std::string>& doubts);

}  // namespace glisson::atlas
