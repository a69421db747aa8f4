// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/volume/morphology.h"

namespace glisson::segmentation {

/// A liver with the places where a tumour at its rim may lie that was taken for something else: its hollows
/// (closing by 50 mm), and 20 mm beyond the mouths of those that are 10 mm deep and more, since such a tumour
/// lifts the capsule.
Mask with_bites(const Mask& liver);

}  // namespace glisson::segmentation
