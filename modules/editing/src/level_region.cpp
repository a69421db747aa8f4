// SPDX-License-Identifier: GPL-3.0-or-later
#include "level_region.h"

#include <cmath>

#include "edit_runs.h"
#include "edit_tools.h"
#include "glisson/core/error.h"
#include "glisson/editing/level_tracing.h"

namespace glisson::editing {
namespace {

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

/// What is connected to `start` and not on the other side of the level: `sign` 1 for brighter, -1 for darker.
LevelRegion region_from(const SmoothedSlice& slice, const Eigen::Vector2i& start, float level, float sign) {
  Mask like({slice.size.x(), slice.size.y(), 1}, Eigen::Vector3d::Ones());
  for (std::size_t n = 0; n < like.voxels.size(); ++n)
    like.voxels[n] = sign * (slice.values[n] - level) >= 0.0F ? 1 : 0;
  const Runs parts(like, 1);
  std::vector<bool> chosen(parts.sizes().size(), false);
  chosen[parts.component_at({start.x(), start.y(), 0})] = true;
  LevelRegion region{Mask(like.size, like.spacing_mm), 0, false};
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
Eigen::Vector2i extreme_pixel(const SmoothedSlice& slice, const Eigen::Vector2i& corner, float sign) {
  Eigen::Vector2i best = corner;
  for (int n = 1; n < 4; ++n) {
    const Eigen::Vector2i p(std::min(corner.x() + (n & 1), slice.size.x() - 1),
                            std::min(corner.y() + (n >> 1), slice.size.y() - 1));
    if (sign * (slice.at(p.x(), p.y()) - slice.at(best.x(), best.y())) > 0.0F) best = p;
  }
  return best;
}

/// The line around a region without holes, along the pixels' edges: its corners, pixel (0, 0) from (-0.5,
/// -0.5). The region is on the right hand all the way.
std::vector<Eigen::Vector2d> line_around(const Mask& mask) {
  const auto inside = [&](const Eigen::Vector2i& p) {
    return p.x() >= 0 && p.y() >= 0 && p.x() < mask.size.x() && p.y() < mask.size.y() &&
           mask.voxels[mask.offset(p.x(), p.y(), 0)] != 0;
  };
  const auto first =
      std::find_if(mask.voxels.begin(), mask.voxels.end(), [](auto voxel) { return voxel != 0; });
  if (first == mask.voxels.end()) return {};
  const auto at = static_cast<int>(first - mask.voxels.begin());
  const Eigen::Vector2i start(at % mask.size.x(), at / mask.size.x());
  // Corner (x, y) is the upper left one of pixel (x, y): the pixels ahead, from there, for each direction.
  static const std::array<Eigen::Vector2i, 4> kStep = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  static const std::array<Eigen::Vector2i, 4> kLeft = {{{0, -1}, {0, 0}, {-1, 0}, {-1, -1}}};
  static const std::array<Eigen::Vector2i, 4> kRight = {{{0, 0}, {-1, 0}, {-1, -1}, {0, -1}}};
  std::vector<Eigen::Vector2d> corners = {start.cast<double>().array() - 0.5};
  Eigen::Vector2i corner = start;
  std::size_t way = 0;
  while (true) {
    corner += kStep[way];
    if (corner == start) return corners;
    const bool left = inside(corner + kLeft[way]), right = inside(corner + kRight[way]);
    if (!left && right) continue;
    way = (way + (left ? 3 : 1)) % 4;
    corners.emplace_back(corner.cast<double>().array() - 0.5);
  }
}

}  // namespace

SmoothedSlice smoothed_slice(const Image& image, int axis, int number) {
  const int u = axis == 0 ? 1 : 0, v = axis == 2 ? 1 : 2;
  SmoothedSlice slice{{image.grid.size[u], image.grid.size[v]}, {}};
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

LevelRegion traced(const SmoothedSlice& slice, const Eigen::Vector2d& place) {
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
  LevelRegion above = region_from(slice, bright, level, 1.0F);
  LevelRegion below = region_from(slice, dark, level, -1.0F);
  // The iso-line bounds one of the two: the one that does not run out of the picture, else the smaller.
  if (above.open != below.open) return above.open ? below : above;
  return below.size < above.size ? below : above;
}

struct LevelTracer::Seen {
  std::shared_ptr<const std::vector<std::int16_t>> voxels;
  int axis = 0, number = 0;
  SmoothedSlice slice;
};

LevelTracer::LevelTracer() = default;
LevelTracer::~LevelTracer() = default;

TracedLevel LevelTracer::trace(const Image& image, int normal_axis, const Point<CtFrame>& p) {
  require(normal_axis >= 0 && normal_axis < 3, "a slice lies across axis 0, 1 or 2");
  const int u = normal_axis == 0 ? 1 : 0, v = normal_axis == 2 ? 1 : 2;
  Eigen::Vector3d index = image.grid.index_of(p);
  const int number = voxel_at(image.grid, p.xyz, "level_tracing")[normal_axis];
  if (!seen_ || seen_->voxels != image.voxels || seen_->axis != normal_axis || seen_->number != number)
    seen_ = std::make_unique<Seen>(
        Seen{image.voxels, normal_axis, number, smoothed_slice(image, normal_axis, number)});
  const LevelRegion region = traced(seen_->slice, {index[u], index[v]});
  const std::vector<Eigen::Vector2d> corners = line_around(region.mask);
  TracedLevel level{Points(static_cast<Eigen::Index>(corners.size()), 3), region.size, region.open};
  index[normal_axis] = number;
  for (std::size_t n = 0; n < corners.size(); ++n) {
    index[u] = corners[n].x();
    index[v] = corners[n].y();
    level.outline.row(static_cast<Eigen::Index>(n)) = image.grid.p_in_ct(index).xyz.transpose();
  }
  return level;
}

}  // namespace glisson::editing
