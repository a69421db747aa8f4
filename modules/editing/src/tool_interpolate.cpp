// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/editing/tools/interpolate.h"

#include <cmath>

#include "describe.h"
#include "edit_shape.h"

namespace glisson::editing {
namespace {

/// One slice of a mask as a mask of one slice.
Mask slice_of(const Mask& mask, int axis, int number) {
  const int u = axis == 0 ? 1 : 0, v = axis == 2 ? 1 : 2;
  Mask slice({mask.size[u], mask.size[v], 1}, {mask.spacing_mm[u], mask.spacing_mm[v], 1.0});
  Eigen::Vector3i at;
  at[axis] = number;
  std::size_t to = 0;
  for (at[v] = 0; at[v] < mask.size[v]; ++at[v])
    for (at[u] = 0; at[u] < mask.size[u]; ++at[u])
      slice.voxels[to++] = mask.voxels[mask.offset(at.x(), at.y(), at.z())];
  return slice;
}

/// Distance in mm to the shape outside it, and minus the distance to the rest inside.
std::vector<float> signed_distance(const Mask& slice) {
  std::vector<float> distance = squared_distance_mm2(slice);
  const std::vector<float> depth = squared_depth_mm2(slice);
  // A slice that is filled to the volume's edges has no rest: as deep as any.
  constexpr float kDeep = 1e4F;
  for (std::size_t n = 0; n < distance.size(); ++n)
    distance[n] = std::sqrt(distance[n]) - std::min(std::sqrt(depth[n]), kDeep);
  return distance;
}

/// Mm: a voxel on the line between the two shapes is not inside, however its distance is rounded.
constexpr float kOnTheLine = 1e-4F;

/// Fills slices first+1 .. last-1 between two that are drawn.
void fill_between(Mask& mask, int axis, int first, int last) {
  const int u = axis == 0 ? 1 : 0, v = axis == 2 ? 1 : 2;
  const std::vector<float> a = signed_distance(slice_of(mask, axis, first));
  const std::vector<float> b = signed_distance(slice_of(mask, axis, last));
  Eigen::Vector3i at;
  for (int n = first + 1; n < last; ++n) {
    const float t = static_cast<float>(n - first) / static_cast<float>(last - first);
    at[axis] = n;
    std::size_t from = 0;
    for (at[v] = 0; at[v] < mask.size[v]; ++at[v])
      for (at[u] = 0; at[u] < mask.size[u]; ++at[u], ++from)
        if ((1.0F - t) * a[from] + t * b[from] < -kOnTheLine)
          mask.voxels[mask.offset(at.x(), at.y(), at.z())] = 1;
  }
}

std::vector<int> drawn_slices(const Mask& mask, int axis) {
  std::vector<bool> drawn(static_cast<std::size_t>(mask.size[axis]), false);
  std::size_t at = 0;
  Eigen::Vector3i v;
  for (v.z() = 0; v.z() < mask.size.z(); ++v.z())
    for (v.y() = 0; v.y() < mask.size.y(); ++v.y())
      for (v.x() = 0; v.x() < mask.size.x(); ++v.x(), ++at)
        if (mask.voxels[at] != 0) drawn[static_cast<std::size_t>(v[axis])] = true;
  std::vector<int> numbers;
  for (std::size_t n = 0; n < drawn.size(); ++n)
    if (drawn[n]) numbers.push_back(static_cast<int>(n));
  return numbers;
}

Cancellable<Canvas> apply(const InterpolateSlices& tool, Task& task) {
  // A voxel about the shape: what is nearest to its inside lies there.
  const VoxelBox box = grown(box_of(task.labels.voxels, {tool.label}), task.grid(), 1e-3);
  Canvas canvas = task.canvas(box);
  bool between = false;
  if (!box.empty()) {
    Mask mask = mask_in(task.labels.voxels, box, {tool.label});
    const std::vector<int> drawn = drawn_slices(mask, tool.normal_axis);
    for (std::size_t n = 1; n < drawn.size(); ++n) {
      if (task.context.cancelled()) return std::nullopt;
      task.context.progress(0.8 * static_cast<double>(n) / static_cast<double>(drawn.size()),
                            "segmentation.edit");
      if (drawn[n] - drawn[n - 1] < 2) continue;
      between = true;
      fill_between(mask, tool.normal_axis, drawn[n - 1], drawn[n]);
    }
    if (between && !reshape(canvas, box, mask, tool.label, task.context.part(0.8, 1.0))) return std::nullopt;
  }
  if (!between) task.notes.emplace_back("no_slices_between");
  return canvas;
}

Description<InterpolateSlices> description() {
  return {"interpolate_slices",
          100,
          {label_field("label", &InterpolateSlices::label), axis_field(&InterpolateSlices::normal_axis)},
          {"interpolate_slices"},
          [](const InterpolateSlices& t) {
            return StepName{"interpolate_slices", t.label, 0.0};
          },
          apply};
}

}  // namespace

const ToolKind& InterpolateSlices::kind() {
  static const Described<InterpolateSlices> kKind(description());
  return kKind;
}
const ToolKind& interpolate_tool() { return InterpolateSlices::kind(); }

}  // namespace glisson::editing
