// SPDX-License-Identifier: GPL-3.0-or-later
#include "edit_tools.h"
#include "glisson/core/error.h"

namespace glisson::segmentation {

Cancellable<Canvas> apply_tool(const ReassignBranch& tool, Task& task) {
  voxel_at(task.grid(), tool.p_in_ct, "reassign_branch");
  throw InputError("reassign_branch", "", "is not in this version", "Paint the branch instead");
}

}  // namespace glisson::segmentation
