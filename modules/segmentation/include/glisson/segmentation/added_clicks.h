// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glisson/segmentation/correct_around.h"
#include "glisson/segmentation/grow_around.h"

namespace glisson::segmentation {

/// The clicks around which labels are to be corrected.
struct AddedClicks {
  std::vector<Click> liver;                ///< see clicks_added()
  std::vector<StructureClick> structures;  ///< see structure_clicks_added()
};

/// Those that `after` has and `before` has not.
/// @param name of what `after` was read from, for the message. @throws InputError there is none.
AddedClicks added_clicks(const Seeds& before, const Seeds& after, const std::string& name);

}  // namespace glisson::segmentation
