// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/segmentation/added_clicks.h"

#include "glisson/core/error.h"

namespace glisson::segmentation {

AddedClicks added_clicks(const Seeds& before, const Seeds& after, const std::string& name) {
  AddedClicks added{clicks_added(before, after), structure_clicks_added(before, after)};
  if (added.liver.empty() && added.structures.empty())
    throw InputError(
        name, "",
        "has no click on the liver, beside it, on its veins or on a lesion that the case does not have",
        "Add one, or leave --correct out");
  return added;
}

}  // namespace glisson::segmentation
