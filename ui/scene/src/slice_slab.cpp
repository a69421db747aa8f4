// SPDX-License-Identifier: GPL-3.0-or-later
#include "slice_slab.h"

#include <array>
#include <limits>

#include "slice_walk.h"

namespace glisson::scene {
namespace {

/// The maximum over some layers of voxels, as a picture of the two other axes (the lower one fastest).
class LayersMaximum {
 public:
  LayersMaximum(const Image& image, int fixed) : fixed_(fixed), voxels_(image.voxels->data()) {
    const Eigen::Vector3i& size = image.grid.size;
    a_ = fixed == 0 ? 1 : 0;
    b_ = 3 - fixed - a_;
    stride_ = {1, size.x(), static_cast<long>(size.x()) * size.y()};
    width_ = size[a_];
    height_ = size[b_];
    values_.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_),
                   std::numeric_limits<float>::lowest());
  }

  void take(int first, int last) {
    if (first > last) return;
    std::vector<std::int16_t> row(static_cast<std::size_t>(width_));
    for (int j = 0; j < height_; ++j) {
      const std::int16_t* from = voxels_ + j * stride(b_);
      row.assign(row.size(), std::numeric_limits<std::int16_t>::min());
      if (fixed_ == 0)
        for (int i = 0; i < width_; ++i)
          row[static_cast<std::size_t>(i)] =
              *std::max_element(from + i * stride(a_) + first, from + i * stride(a_) + last + 1);
      else
        for (int layer = first; layer <= last; ++layer) join(row, from + layer * stride(fixed_));
      std::copy(row.begin(), row.end(), line(j));
    }
  }

  /// The place between two layers.
  void take(const Between& depth) {
    const auto t = static_cast<float>(depth.t);
    for (int j = 0; j < height_; ++j)
      for (int i = 0; i < width_; ++i) {
        const std::int16_t* from = voxels_ + j * stride(b_) + i * stride(a_);
        const float value = (1.0F - t) * static_cast<float>(from[depth.low * stride(fixed_)]) +
                            t * static_cast<float>(from[depth.high * stride(fixed_)]);
        line(j)[i] = std::max(line(j)[i], value);
      }
  }

  /// Between the voxels.
  double at(const Between& column, const Between& row, int across) const {
    const Between &i = across == a_ ? column : row, &j = across == a_ ? row : column;
    const auto along = [&](int y) {
      const float* from = values_.data() + static_cast<std::ptrdiff_t>(y) * width_;
      return (1.0 - i.t) * static_cast<double>(from[i.low]) + i.t * static_cast<double>(from[i.high]);
    };
    return (1.0 - j.t) * along(j.low) + j.t * along(j.high);
  }

 private:
  long stride(int axis) const { return stride_[static_cast<std::size_t>(axis)]; }
  float* line(int j) { return values_.data() + static_cast<std::ptrdiff_t>(j) * width_; }
  static void join(std::vector<std::int16_t>& row, const std::int16_t* other) {
    for (std::size_t i = 0; i < row.size(); ++i) row[i] = std::max(row[i], other[i]);
  }

  int fixed_, a_ = 0, b_ = 1, width_ = 0, height_ = 0;
  std::array<long, 3> stride_{};
  const std::int16_t* voxels_;
  std::vector<float> values_;
};

void draw_aligned(const Image& image, const VoxelWalk& walk, const SliceGeometry& slice,
                  const SliceStyle& style, std::vector<std::uint8_t>& bytes) {
  const Eigen::Vector3i& size = image.grid.size;
  const Between depth(walk.start[walk.fixed], size[walk.fixed]);
  if (!depth.inside) return;
  constexpr double kRounding = 1e-6;  // voxels
  const double middle = walk.start[walk.fixed],
               half = 0.5e3 * style.slab / image.grid.spacing_mm[walk.fixed] + kRounding;
  const int first = std::max(0, static_cast<int>(std::ceil(middle - half))),
            last = std::min(size[walk.fixed] - 1, static_cast<int>(std::floor(middle + half)));
  LayersMaximum maximum(image, walk.fixed);
  maximum.take(first, last);
  // A slab that reaches no layer on one side: the slice itself may be brighter than all layers in it.
  if (depth.low < first || (depth.t > 0.0 ? depth.high : depth.low) > last) maximum.take(depth);
  std::vector<Between> columns;
  columns.reserve(static_cast<std::size_t>(slice.width));
  for (int u = 0; u < slice.width; ++u)
    columns.emplace_back(walk.start[walk.across] + u * walk.right[walk.across], size[walk.across]);
  const Greys greys(style);
  std::size_t at = 0;
  for (int v = 0; v < slice.height; ++v) {
    const Between row(walk.start[walk.along] + v * walk.down[walk.along], size[walk.along]);
    for (const Between& column : columns) {
      if (row.inside && column.inside)
        bytes[at] = bytes[at + 1] = bytes[at + 2] = greys.of(maximum.at(column, row, walk.across));
      at += 3;
    }
  }
}

/// Trilinear, of a place inside the volume.
class Samples {
 public:
  explicit Samples(const Image& image)
      : voxels_(image.voxels->data()),
        row_(image.grid.size.x()),
        layer_(static_cast<long>(image.grid.size.x()) * image.grid.size.y()),
        last_((image.grid.size.array() - 1).matrix().cast<float>()) {}

  bool holds(const Eigen::Vector3f& index) const {
    return (index.array() >= -0.5F).all() && (index.array() <= last_.array() + 0.5F).all();
  }
  float at(const Eigen::Vector3f& index) const {
    const Eigen::Vector3f p = index.cwiseMax(0.0F).cwiseMin(last_);
    const auto i = static_cast<long>(p.x()), j = static_cast<long>(p.y()), k = static_cast<long>(p.z());
    const float x = p.x() - static_cast<float>(i), y = p.y() - static_cast<float>(j),
                z = p.z() - static_cast<float>(k);
    const long right = x > 0.0F ? 1 : 0, down = y > 0.0F ? row_ : 0, deep = z > 0.0F ? layer_ : 0;
    const std::int16_t* from = voxels_ + i + j * row_ + k * layer_;
    const auto line = [&](const std::int16_t* v) {
      return static_cast<float>(v[0]) + x * static_cast<float>(v[right] - v[0]);
    };
    const auto sheet = [&](const std::int16_t* v) { return line(v) + y * (line(v + down) - line(v)); };
    return sheet(from) + z * (sheet(from + deep) - sheet(from));
  }

 private:
  const std::int16_t* voxels_;
  long row_, layer_;
  Eigen::Vector3f last_;
};

/// Through a volume that lies askew: a sample a voxel along the slice's normal.
void draw_askew(const Image& image, const VoxelWalk& walk, const SliceGeometry& slice,
                const SliceStyle& style, std::vector<std::uint8_t>& bytes) {
  const Eigen::Vector3d normal = slice.right.cross(slice.down).normalized();
  const Eigen::Vector3d per_metre = image.grid.index_of(Point<CtFrame>(slice.origin + normal)) -
                                    image.grid.index_of(Point<CtFrame>(slice.origin));
  const double step = 1.0 / per_metre.cwiseAbs().maxCoeff();  // metres
  const int samples = static_cast<int>(std::floor(0.5 * style.slab / step + 1e-6));
  const Eigen::Vector3f deeper = (step * per_metre).cast<float>();
  const Samples volume(image);
  const Greys greys(style);
  std::size_t at = 0;
  for (int v = 0; v < slice.height; ++v)
    for (int u = 0; u < slice.width; ++u, at += 3) {
      const Eigen::Vector3f middle = walk.at(u, v).cast<float>();
      if (!volume.holds(middle)) continue;
      float brightest = std::numeric_limits<float>::lowest();
      for (int k = -samples; k <= samples; ++k) {
        const Eigen::Vector3f place = middle + static_cast<float>(k) * deeper;
        if (volume.holds(place)) brightest = std::max(brightest, volume.at(place));
      }
      bytes[at] = bytes[at + 1] = bytes[at + 2] = greys.of(static_cast<double>(brightest));
    }
}

}  // namespace

void draw_slab(const Image& image, const SliceGeometry& slice, const SliceStyle& style,
               std::vector<std::uint8_t>& bytes) {
  const VoxelWalk walk(image.grid, slice);
  if (walk.aligned)
    draw_aligned(image, walk, slice, style, bytes);
  else
    draw_askew(image, walk, slice, style, bytes);
}

}  // namespace glisson::scene
