// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "edit_runs.h"
#include "edit_shape.h"
#include "edit_tools.h"

namespace glisson::segmentation {
namespace {

/// One slice of the image, smoothed by a binomial of five so that noise does not tear the iso-line.
struct Slice {
  Eigen::Vector2i size;
  std::vector<float> values;

  float at(int u, int v) const {
    return values[static_cast<std::size_t>(u) +
                  static_cast<std::size_t>(size.x()) * static_cast<std::size_t>(v)];
  }
};

void smooth_lines(std::vector<float>& values, int length, std::size_t stride, int lines, std::size_t apart) {
  std::vector<float> line(static_cast<std::size_t>(length) + 4);
  for (int n = 0; n < lines; ++n) {
    float* const start = values.data() + static_cast<std::size_t>(n) * apart;
    for (int p = -2; p < length + 2; ++p)
      line[static_cast<std::size_t>(p + 2)] =
          start[static_cast<std::size_t>(std::clamp(p, 0, length - 1)) * stride];
    for (int p = 0; p < length; ++p) {
      const float* c = line.data() + p;
      start[static_cast<std::size_t>(p) * stride] =
          (c[0] + c[4] + 4.0F * (c[1] + c[3]) + 6.0F * c[2]) * (1.0F / 16.0F);
    }
  }
}

Slice slice_of(const Image& image, int axis, int number) {
  const int u = axis == 0 ? 1 : 0, v = axis == 2 ? 1 : 2;
  Slice slice{{image.grid.size[u], image.grid.size[v]}, {}};
  slice.values.reserve(static_cast<std::size_t>(slice.size.prod()));
  Eigen::Vector3i at;
  at[axis] = number;
  for (at[v] = 0; at[v] < slice.size.y(); ++at[v])
    for (at[u] = 0; at[u] < slice.size.x(); ++at[u]) slice.values.push_back(image.at(at));
  const auto width = static_cast<std::size_t>(slice.size.x());
  smooth_lines(slice.values, slice.size.x(), 1, slice.size.y(), width);
  smooth_lines(slice.values, slice.size.y(), width, slice.size.x(), 1);
  return slice;
}

/// A region of the slice without holes.
struct Region {
  Mask mask;
  long size = 0;
  bool open = false;  ///< it reaches the slice's edge
};

/// What is connected to `start` and not on the other side of the level: `sign` 1 for brighter, -1 for darker.
Region region_from(const Slice& slice, const Eigen::Vector2i& start, float level, float sign) {
  Mask like({slice.size.x(), slice.size.y(), 1}, Eigen::Vector3d::Ones());
  for (std::size_t n = 0; n < like.voxels.size(); ++n)
    like.voxels[n] = sign * (slice.values[n] - level) >= 0.0F ? 1 : 0;
  const Runs parts(like, 1);
  std::vector<bool> chosen(parts.sizes().size(), false);
  chosen[parts.component_at({start.x(), start.y(), 0})] = true;
  Region region{Mask(like.size, like.spacing_mm), 0, false};
  parts.write(chosen, 1, region.mask);
  // Along the third axis every voxel of one slice lies at a face: the slice's own edge is what counts.
  const auto at_edge = [&](const Runs::Run& run) {
    return run.first == 0 || run.end == slice.size.x() || run.row == 0 ||
           run.row + 1 == static_cast<std::size_t>(slice.size.y());
  };
  for (const Runs::Run& run : parts.runs())
    region.open = region.open || (chosen[run.component] && at_edge(run));
  const Runs gaps(region.mask, 0);
  std::vector<bool> holes(gaps.sizes().size(), true);
  for (const Runs::Run& run : gaps.runs())
    if (at_edge(run)) holes[run.component] = false;
  gaps.write(holes, 1, region.mask);
  region.size = region.mask.count();
  return region;
}

/// The pixel about a place that is brightest (sign 1) or darkest (-1): one of the four is on either side of
/// the level interpolated between them.
Eigen::Vector2i extreme_pixel(const Slice& slice, const Eigen::Vector2i& corner, float sign) {
  Eigen::Vector2i best = corner;
  for (int n = 1; n < 4; ++n) {
    const Eigen::Vector2i p(std::min(corner.x() + (n & 1), slice.size.x() - 1),
                            std::min(corner.y() + (n >> 1), slice.size.y() - 1));
    if (sign * (slice.at(p.x(), p.y()) - slice.at(best.x(), best.y())) > 0.0F) best = p;
  }
  return best;
}

Region traced(const Slice& slice, const Eigen::Vector2d& place) {
  const Eigen::Vector2d inside =
      place.cwiseMax(0.0).cwiseMin((slice.size - Eigen::Vector2i::Ones()).cast<double>());
  const Eigen::Vector2i corner = inside.array().floor().matrix().cast<int>();
  const Eigen::Vector2f f = (inside - corner.cast<double>()).cast<float>();
  const auto value = [&](int du, int dv) {
    return slice.at(std::min(corner.x() + du, slice.size.x() - 1),
                    std::min(corner.y() + dv, slice.size.y() - 1));
  };
  const float interpolated = (1.0F - f.y()) * ((1.0F - f.x()) * value(0, 0) + f.x() * value(1, 0)) +
                             f.y() * ((1.0F - f.x()) * value(0, 1) + f.x() * value(1, 1));
  const Eigen::Vector2i bright = extreme_pixel(slice, corner, 1.0F),
                        dark = extreme_pixel(slice, corner, -1.0F);
  // Rounding may put the interpolated value beyond the values that it lies between.
  const float level =
      std::clamp(interpolated, slice.at(dark.x(), dark.y()), slice.at(bright.x(), bright.y()));
  Region above = region_from(slice, bright, level, 1.0F);
  Region below = region_from(slice, dark, level, -1.0F);
  // The iso-line bounds one of the two: the one that does not run out of the picture, else the smaller.
  if (above.open != below.open) return above.open ? below : above;
  return below.size < above.size ? below : above;
}

}  // namespace

Cancellable<Canvas> apply_tool(const LevelTracing& tool, Task& task) {
  const VolumeGrid& grid = task.grid();
  const int axis = tool.normal_axis, u = axis == 0 ? 1 : 0, v = axis == 2 ? 1 : 2;
  const int number = voxel_at(grid, tool.p_in_ct, "level_tracing")[axis];
  const Eigen::Vector3d index = grid.index_of(Point<CtFrame>(tool.p_in_ct));
  VoxelBox box = whole_box(grid);
  box.low[axis] = number;
  box.high[axis] = number + 1;
  const Region region = traced(slice_of(task.image, axis, number), {index[u], index[v]});
  if (region.open) task.notes.emplace_back("level_tracing.open");
  Canvas canvas = task.canvas(box);
  const bool gathers = tool.erase && lies_in_liver(tool.label);
  std::vector<Eigen::Vector3i> lost;
  const bool done =
      canvas.rewrite(box, task.context.part(0.0, 0.8), [&](int i, int j, int k, Label old) -> Label {
        const std::array<int, 3> place = {i, j, k};
        if (region.mask.voxels[region.mask.offset(place[static_cast<std::size_t>(u)],
                                                  place[static_cast<std::size_t>(v)], 0)] == 0)
          return old;
        if (!tool.erase) return tool.label;
        if (tool.label != structure::kBackground && old != tool.label) return old;
        if (gathers) lost.emplace_back(i, j, k);
        return gathers ? old : structure::kBackground;
      });
  if (!done || !take_away(canvas, lost, tool.label, task.context.part(0.8, 1.0))) return std::nullopt;
  return canvas;
}

}  // namespace glisson::segmentation
