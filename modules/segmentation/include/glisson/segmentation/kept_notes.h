// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "glisson/patient/label_map.h"

namespace glisson::segmentation {

/// What is told of labels that were found in part anew: what was told then, behind those notes of the former
/// labels that are about structures which were kept.
/// @param former of the former labels. What is told of all labels each time (volumes,
///   borders, sides) is not taken from them.
/// @param is_kept whether a structure is as it was.
std::vector<std::string> with_kept_notes(const std::vector<std::string>& former,
                                         const std::function<bool(Label)>& is_kept,
                                         std::vector<std::string> told);

}  // namespace glisson::segmentation
