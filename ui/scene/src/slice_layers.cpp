// SPDX-License-Identifier: GPL-3.0-or-later
#include "slice_layers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "glisson/core/error.h"
#include "glisson/patient/label_map.h"
#include "slice_slab.h"
#include "slice_walk.h"

namespace glisson::scene {
namespace {

void draw_grey_aligned(const Image& image, const VoxelWalk& walk, const SliceGeometry& slice,
                       const Greys& greys, std::vector<std::uint8_t>& bytes) {
  const Eigen::Vector3i& size = image.grid.size;
  const std::array<long, 3> stride = {1, size.x(), static_cast<long>(size.x()) * size.y()};
  const auto stride_of = [&](int axis) { return stride[static_cast<std::size_t>(axis)]; };
  const Between depth(walk.start[walk.fixed], size[walk.fixed]);
  if (!depth.inside) return;
  std::vector<Between> columns;
  columns.reserve(static_cast<std::size_t>(slice.width));
  for (int u = 0; u < slice.width; ++u)
    columns.emplace_back(walk.start[walk.across] + u * walk.right[walk.across], size[walk.across]);
  const std::int16_t* voxels = image.voxels->data();
  const bool between_columns =
      std::any_of(columns.begin(), columns.end(), [](const Between& column) { return column.t > 0.0; });
  std::size_t at = 0;
  for (int v = 0; v < slice.height; ++v) {
    const Between row(walk.start[walk.along] + v * walk.down[walk.along], size[walk.along]);
    if (!row.inside) {
      at += 3 * static_cast<std::size_t>(slice.width);
      continue;
    }
    const auto line = [&](int layer, int y) {
      return voxels + layer * stride_of(walk.fixed) + y * stride_of(walk.along);
    };
    const std::array<const std::int16_t*, 4> lines = {line(depth.low, row.low), line(depth.low, row.high),
                                                      line(depth.high, row.low), line(depth.high, row.high)};
    const long step = stride_of(walk.across);
    const bool between_rows = row.t > 0.0;
    for (const Between& column : columns) {
      const long low = column.low * step, high = column.high * step;
      const auto across = [&](const std::int16_t* from) {
        return between_columns ? (1.0 - column.t) * from[low] + column.t * from[high] : from[low];
      };
      const auto layer = [&](std::size_t first) {
        return between_rows ? (1.0 - row.t) * across(lines[first]) + row.t * across(lines[first + 1])
                            : across(lines[first]);
      };
      const double value = depth.t > 0.0 ? (1.0 - depth.t) * layer(0) + depth.t * layer(2) : layer(0);
      if (column.inside) bytes[at] = bytes[at + 1] = bytes[at + 2] = greys.of(value);
      at += 3;
    }
  }
}

/// Trilinear value; false outside.
bool interpolate(const Image& image, const Eigen::Vector3d& index, double& value) {
  const Eigen::Vector3i& size = image.grid.size;
  const Between x(index.x(), size.x()), y(index.y(), size.y()), z(index.z(), size.z());
  if (!x.inside || !y.inside || !z.inside) return false;
  const std::int16_t* voxels = image.voxels->data();
  const auto row = [&](int j, int k) {
    const long base = static_cast<long>(size.x()) * (j + static_cast<long>(size.y()) * k);
    return (1.0 - x.t) * voxels[base + x.low] + x.t * voxels[base + x.high];
  };
  const auto layer = [&](int k) { return (1.0 - y.t) * row(y.low, k) + y.t * row(y.high, k); };
  value = (1.0 - z.t) * layer(z.low) + z.t * layer(z.high);
  return true;
}

/// Of labels as they are drawn, blue first.
class Palette {
 public:
  Palette() {
    for (std::size_t label = 0; label < known_.size(); ++label)
      known_[label] = bgr(static_cast<Label>(label));
  }
  std::array<double, 3> of(Label label) const { return label < known_.size() ? known_[label] : bgr(label); }

 private:
  static std::array<double, 3> bgr(Label label) {
    const auto rgb = structure_colour(label);
    return {255.0 * rgb[2], 255.0 * rgb[1], 255.0 * rgb[0]};
  }
  std::array<std::array<double, 3>, 64> known_{};
};

}  // namespace

PixelBox PixelBox::joined(const PixelBox& other) const {
  if (empty()) return other;
  if (other.empty()) return *this;
  return {std::min(left, other.left), std::min(top, other.top), std::max(right, other.right),
          std::max(bottom, other.bottom)};
}

PixelBox PixelBox::grown(int pixels, const SliceGeometry& slice) const {
  if (empty()) return {};
  return {std::max(0, left - pixels), std::max(0, top - pixels), std::min(slice.width, right + pixels),
          std::min(slice.height, bottom + pixels)};
}

void draw_grey(const Image& image, const SliceGeometry& slice, const SliceStyle& style,
               std::vector<std::uint8_t>& bytes) {
  if (style.slab > 0.0) return draw_slab(image, slice, style, bytes);
  const VoxelWalk walk(image.grid, slice);
  const Greys greys(style);
  if (walk.aligned) return draw_grey_aligned(image, walk, slice, greys, bytes);
  std::size_t at = 0;
  for (int v = 0; v < slice.height; ++v)
    for (int u = 0; u < slice.width; ++u, at += 3) {
      double value = 0.0;
      if (interpolate(image, walk.at(u, v), value))
        bytes[at] = bytes[at + 1] = bytes[at + 2] = greys.of(value);
    }
}

void sample_labels(const LabelVolume& labels, const SliceGeometry& slice, const PixelBox& box,
                   std::vector<Label>& found) {
  const VoxelWalk walk(labels.grid(), slice);
  const auto row_of = [&](int v) {
    return found.data() + static_cast<std::ptrdiff_t>(v) * static_cast<std::ptrdiff_t>(slice.width);
  };
  if (!walk.aligned) {
    for (int v = box.top; v < box.bottom; ++v)
      for (int u = box.left; u < box.right; ++u) {
        const Eigen::Vector3i voxel = walk.at(u, v).array().round().cast<int>().matrix();
        row_of(v)[u] = labels.grid().contains(voxel) ? labels.at(voxel) : Label{0};
      }
    return;
  }
  const Eigen::Vector3i &size = labels.grid().size, &bricks = labels.brick_counts();
  constexpr int kSide = LabelVolume::kSide;
  /// What a voxel's index along one axis adds to its brick's number, and to its offset in the brick.
  struct Place {
    bool inside;
    std::size_t brick, voxel;
  };
  const auto place = [&](int axis, double index) {
    const auto i = static_cast<int>(std::lround(index));
    if (i < 0 || i >= size[axis]) return Place{false, 0, 0};
    const std::size_t per_brick =
        axis == 0   ? 1
        : axis == 1 ? static_cast<std::size_t>(bricks.x())
                    : static_cast<std::size_t>(bricks.x()) * static_cast<std::size_t>(bricks.y());
    const std::size_t per_voxel = axis == 0 ? 1 : axis == 1 ? kSide : kSide * kSide;
    return Place{true, per_brick * static_cast<std::size_t>(i / kSide),
                 per_voxel * static_cast<std::size_t>(i % kSide)};
  };
  const Place depth = place(walk.fixed, walk.start[walk.fixed]);
  std::vector<Place> columns;
  columns.reserve(static_cast<std::size_t>(std::max(0, box.right - box.left)));
  for (int u = box.left; u < box.right; ++u)
    columns.push_back(place(walk.across, walk.start[walk.across] + u * walk.right[walk.across]));
  for (int v = box.top; v < box.bottom; ++v) {
    Label* out = row_of(v) + box.left;
    const Place row = place(walk.along, walk.start[walk.along] + v * walk.down[walk.along]);
    const bool meets = depth.inside && row.inside;
    for (const Place& column : columns) {
      const LabelVolume::Brick* brick =
          meets && column.inside ? labels.brick(depth.brick + row.brick + column.brick).get() : nullptr;
      *out++ = brick == nullptr ? Label{0} : (*brick)[depth.voxel + row.voxel + column.voxel];
    }
  }
}

void blend_labels(const std::vector<Label>& labels, const SliceGeometry& slice, const SliceStyle& style,
                  const PixelBox& box, std::vector<std::uint8_t>& bytes) {
  const Palette palette;
  const auto width = static_cast<std::size_t>(slice.width);
  for (int v = box.top; v < box.bottom; ++v)
    for (int u = box.left; u < box.right; ++u) {
      const std::size_t at = static_cast<std::size_t>(v) * width + static_cast<std::size_t>(u);
      const Label label = labels[at];
      if (label == structure::kBackground || style.hides(label)) continue;
      const bool edge =
          (u > 0 && labels[at - 1] != label) || (u + 1 < slice.width && labels[at + 1] != label) ||
          (v > 0 && labels[at - width] != label) || (v + 1 < slice.height && labels[at + width] != label);
      const auto colour = palette.of(label);
      const double alpha = edge ? 0.95 : style.label_opacity;
      for (std::size_t c = 0; c < 3; ++c)
        bytes[3 * at + c] = static_cast<std::uint8_t>((1.0 - alpha) * bytes[3 * at + c] + alpha * colour[c]);
    }
}

PixelBox pixels_of_brick(const LabelVolume& labels, std::size_t brick, const SliceGeometry& slice) {
  const VolumeGrid& grid = labels.grid();
  const Eigen::Vector3d low = (LabelVolume::kSide * labels.brick_place(brick)).cast<double>().array() - 0.5;
  double nearest = std::numeric_limits<double>::max(), farthest = std::numeric_limits<double>::lowest();
  Eigen::Array2d from = Eigen::Array2d::Constant(nearest), to = Eigen::Array2d::Constant(farthest);
  for (int corner = 0; corner < 8; ++corner) {
    Eigen::Vector3d index = low;
    for (int k = 0; k < 3; ++k)
      if (((corner >> k) & 1) != 0) index[k] += LabelVolume::kSide;
    const Point<CtFrame> p = grid.p_in_ct(index);
    const Eigen::Array2d pixel = slice.pixel_of(p).array();
    from = from.min(pixel);
    to = to.max(pixel);
    nearest = std::min(nearest, slice.distance_of(p));
    farthest = std::max(farthest, slice.distance_of(p));
  }
  constexpr double kRounding = 1e-9;  // metres
  if (nearest > kRounding || farthest < -kRounding) return {};
  const PixelBox box = {static_cast<int>(std::floor(from.x())), static_cast<int>(std::floor(from.y())),
                        static_cast<int>(std::ceil(to.x())) + 1, static_cast<int>(std::ceil(to.y())) + 1};
  return PixelBox{std::max(0, box.left), std::max(0, box.top), std::min(slice.width, box.right),
                  std::min(slice.height, box.bottom)};
}

PixelBox pixels_that_may_differ(const LabelVolume& a, const LabelVolume& b, const SliceGeometry& slice) {
  require(a.brick_count() == b.brick_count(), "two label volumes are compared on one grid");
  PixelBox box;
  for (std::size_t n = 0; n < a.brick_count(); ++n)
    if (a.brick(n) != b.brick(n)) box = box.joined(pixels_of_brick(a, n, slice));
  return box;
}

}  // namespace glisson::scene
