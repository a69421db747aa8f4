// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "edit_canvas.h"

namespace glisson::editing {

/// What a tool works on.
struct Task {
  const LabelMap& labels;
  const Image& image;
  const EditableRegion& region;
  const RunContext& context;
  std::vector<std::string> notes = {};

  const VolumeGrid& grid() const { return labels.voxels.grid(); }
  /// Canvas whose work box is `box`.
  Canvas canvas(const VoxelBox& box) const { return {labels, image, region, box}; }
};

/// Each tool, with settings that check_edit() has passed. Empty: cancelled.
Cancellable<Canvas> apply_tool(const Paint& tool, Task& task);
Cancellable<Canvas> apply_tool(const Threshold& tool, Task& task);
Cancellable<Canvas> apply_tool(const Scissors& tool, Task& task);
Cancellable<Canvas> apply_tool(const GrowFromSeeds& tool, Task& task);
Cancellable<Canvas> apply_tool(const LevelTracing& tool, Task& task);
Cancellable<Canvas> apply_tool(const Islands& tool, Task& task);
Cancellable<Canvas> apply_tool(const FillHoles& tool, Task& task);
Cancellable<Canvas> apply_tool(const Smooth& tool, Task& task);
Cancellable<Canvas> apply_tool(const Margin& tool, Task& task);
Cancellable<Canvas> apply_tool(const InterpolateSlices& tool, Task& task);
Cancellable<Canvas> apply_tool(const Logical& tool, Task& task);
Cancellable<Canvas> apply_tool(const ReassignBranch& tool, Task& task);

/// "paint", "grow_from_seeds", ...: of scripts and messages.
std::string tool_name(const Tool& tool);
/// @throws InputError settings that no image can make good; names the tool as file and its setting as field.
void check_edit(const Edit& edit);
/// @throws InputError when the point lies outside the volume.
Eigen::Vector3i voxel_at(const VolumeGrid& grid, const Eigen::Vector3d& p_in_ct, const char* tool);

}  // namespace glisson::editing
