// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/editing/edit.h"

#include <cmath>

#include "edit_tools.h"
#include "glisson/core/error.h"

namespace glisson::editing {
StepName step_name(const Edit& edit) { return edit.tool.kind().step(edit.tool); }

bool is_local(const Tool& tool) { return tool.kind().is_local(tool); }

void check_edit(const Edit& edit) { edit.tool.kind().check(edit.tool, edit.region); }

Eigen::Vector3i voxel_at(const VolumeGrid& grid, const Eigen::Vector3d& p_in_ct, const char* tool) {
  const Eigen::Vector3d index = grid.index_of(Point<CtFrame>(p_in_ct)).array().round();
  if ((index.array() < 0.0).any() || (index.array() >= grid.size.array().cast<double>()).any())
    throw InputError(tool, "p_in_ct", "lies outside the volume", "Click inside the picture");
  return index.cast<int>();
}

VoxelBox reachable(const Task& task) {
  using Area = EditableRegion::Area;
  const VoxelBox whole = whole_box(task.grid());
  switch (task.region.area) {
    case Area::inside_label:
      return box_of(task.labels.voxels, {task.region.label});
    case Area::inside_liver:
      // What the liver encloses is no larger than the liver.
      return box_of(task.labels.voxels, liver_tissue());
    default:
      return whole;
  }
}

Cancellable<Edited> apply_edit(const LabelMap& labels, const Image& image, const Edit& edit,
                               const RunContext& context) {
  require(labels.voxels.grid().same_as(image.grid) && (image.empty() == labels.voxels.empty()),
          "the labels that are edited and the image have one grid");
  check_edit(edit);
  if (context.cancelled()) return std::nullopt;
  context.progress(0.0, "segmentation.edit");
  Task task{labels, image, edit.region, context};
  const Cancellable<Canvas> canvas = edit.tool.kind().apply(edit.tool, task);
  if (!canvas || context.cancelled()) return std::nullopt;
  Edited edited{canvas->finish(), canvas->changed(), std::move(task.notes)};
  if (edited.voxels_changed == 0) edited.notes.emplace_back("nothing_changed");
  context.progress(1.0, "segmentation.edit");
  return edited;
}

}  // namespace glisson::editing
