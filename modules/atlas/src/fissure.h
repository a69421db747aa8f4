// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "glisson/atlas/transfer.h"
#include "umbilical_part.h"

/// @file
/// Notch and falciform line at the umbilical fissure, where the portal vein shows it (README: "Umbilical
/// fissure"). `upright` turns the CT's frame into the atlas' (axes to the patient's left, back and head).

namespace glisson::atlas {

/// The vein's umbilical part. Empty: the trees do not show it, or show it where it cannot be; a doubt says
/// so.
/// @param proposals of all structures, with what the image and a person show of them. @param foretold the
/// same from statistics alone. @param portal_vein its trees, CT frame, metres.
std::optional<UmbilicalPart> fissure_part(const std::vector<Proposal>& proposals,
                                          const std::vector<Proposal>& foretold,
                                          const std::vector<VesselTree>& portal_vein,
                                          const Eigen::Matrix3d& upright, std::vector<std::string>& doubts);

/// Whether the notch may lie where it is proposed, by the part; else the two contradict each other, and a
/// doubt says so.
bool agrees(const Proposal& notch, const UmbilicalPart& part, const Eigen::Matrix3d& upright,
            std::vector<std::string>& doubts);

/// Fuses what is known of the notch with what the part says of it.
void draw_notch(Proposal& notch, const UmbilicalPart& part, const Eigen::Matrix3d& upright);

/// The same of the line, across the fissure's plane, which is known the better the nearer the vein is.
void draw_line(Proposal& line, const UmbilicalPart& part, const Eigen::Matrix3d& upright);

}  // namespace glisson::atlas
