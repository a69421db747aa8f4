// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

/// Also of different sizes.
template <class Matrix>
bool same_matrix(const Matrix& a, const Matrix& b) {
  return a.rows() == b.rows() && a.cols() == b.cols() && (a.array() == b.array()).all();
}
/// @throws InputError settings that no image can make good; names the tool as file and its setting as field.
void check_edit(const Edit& edit);
/// Where voxels can change at all, as the editable region says without a look at single voxels.
VoxelBox reachable(const Task& task);
/// @throws InputError when the point lies outside the volume.
Eigen::Vector3i voxel_at(const VolumeGrid& grid, const Eigen::Vector3d& p_in_ct, const char* tool);

}  // namespace glisson::editing
