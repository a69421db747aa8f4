// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "field.h"
#include "glisson/core/run_context.h"
#include "liver.h"

namespace glisson::segmentation {

/// A liver with what belongs to it though it does not look like it: tumours, necroses and cysts, also large
/// ones at its rim that no click marks. In the hollows of the liver found so far (with_bites()) soft
/// tissue belongs to it where that is the better parting (see best_region()): where a body shares more of its
/// border with the liver than with what lies beside it, edges counting little, and where the liver encloses
/// it: from a tumour at the rim more than half of what is seen is liver, from a muscle or a stomach that
/// leans on it less. Fluid has to be more deeply enclosed: a gallbladder lies in a bed.
/// @param found the liver so far; what lies 4 mm deep in it stays. @param liver its parenchyma. @param like
/// what looks like liver.
/// @param own what of that is the liver's: the rest was parted from it at necks and seams, and stays so.
/// @param barred known not to be liver. @param included known to be. @param likely more likely than not.
/// @return one piece without holes but those that are barred. Empty: cancelled.
Cancellable<Mask> with_enclosed(const Field& ct, const Mask& found, const Tissue& liver, const Mask& like,
                                const Mask& own, const Mask& barred, const Mask& included, const Mask& likely,
                                const LiverSeeds& seeds, const RunContext& context);

}  // namespace glisson::segmentation
