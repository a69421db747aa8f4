// SPDX-License-Identifier: GPL-3.0-or-later
#include "scalar_field.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "glisson/core/error.h"
#include "glisson/geometry/closest_point_tree.h"

namespace glisson::model {
namespace {

constexpr float kFar = 1e3F;  // millimetres: beyond the band only the sign counts

/// Gaussian along one axis, zero outside.
void blur_axis(std::vector<float>& values, const Eigen::Vector3i& size, int axis, double sigma_voxels) {
  const int reach = std::max(1, static_cast<int>(std::ceil(3.0 * sigma_voxels)));
  std::vector<float> kernel(static_cast<std::size_t>(2 * reach + 1));
  float sum = 0.0F;
  for (int i = -reach; i <= reach; ++i) {
    kernel[i + reach] = static_cast<float>(std::exp(-0.5 * i * i / (sigma_voxels * sigma_voxels)));
    sum += kernel[i + reach];
  }
  for (float& weight : kernel) weight /= sum;
  const long stride = axis == 0 ? 1L : axis == 1 ? size.x() : static_cast<long>(size.x()) * size.y();
  const int length = size[axis];
  const long lines = static_cast<long>(values.size()) / length;
  std::vector<float> line(static_cast<std::size_t>(length) + 2UL * reach, 0.0F);
  for (long l = 0; l < lines; ++l) {
    const long start = axis == 2 ? l : axis == 0 ? l * length : (l / stride) * stride * length + l % stride;
    for (int i = 0; i < length; ++i) line[i + reach] = values[start + i * stride];
    for (int i = 0; i < length; ++i) {
      float value = 0.0F;
      for (int k = 0; k <= 2 * reach; ++k) value += kernel[k] * line[i + k];
      values[start + i * stride] = value;
    }
  }
}

VolumeGrid part_of(const VolumeGrid& grid, const Eigen::Vector3i& low, const Eigen::Vector3i& size) {
  VolumeGrid part = grid;
  part.size = size;
  part.origin_mm = 1e3 * grid.p_in_ct(low.cast<double>()).xyz;
  return part;
}

/// Exact distances where the sign changes within two voxels; the sign alone elsewhere.
void measure_band(const TriangleMesh& surface, const VolumeGrid& grid,
                  const std::vector<std::uint8_t>& inside, std::vector<float>& values) {
  const ClosestPointTree tree(surface);
  Mask in(grid.size, grid.spacing_mm), out(grid.size, grid.spacing_mm);
  in.voxels = inside;
  for (std::size_t i = 0; i < inside.size(); ++i) out.voxels[i] = inside[i] == 0;
  const std::vector<float> to_in = squared_distance_mm2(in), to_out = squared_distance_mm2(out);
  const double band = 2.0 * grid.spacing_mm.maxCoeff();
  for (int k = 0; k < grid.size.z(); ++k) {
    for (int j = 0; j < grid.size.y(); ++j) {
      for (int i = 0; i < grid.size.x(); ++i) {
        const Eigen::Vector3i v(i, j, k);
        const auto at = static_cast<std::size_t>(grid.offset(v));
        if (std::max(to_in[at], to_out[at]) > band * band) {
          values[at] = inside[at] ? std::sqrt(to_out[at]) : -std::min(kFar, std::sqrt(to_in[at]));
          continue;
        }
        const double distance = 1e3 * tree.closest(grid.p_in_ct(v.cast<double>()).xyz).distance;
        values[at] = static_cast<float>(inside[at] ? distance : -distance);
      }
    }
  }
}

}  // namespace

ScalarField::ScalarField(const VolumeGrid& grid, std::vector<float> values)
    : grid_(grid), values_(std::move(values)) {
  require(static_cast<long>(values_.size()) == grid.voxel_count(), "a field needs one value a voxel");
  const Eigen::Matrix3d inverse = grid.direction.inverse();
  index_from_ct_ = 1e3 * grid.spacing_mm.cwiseInverse().asDiagonal() * inverse;
  offset_ = -(grid.spacing_mm.cwiseInverse().asDiagonal() * inverse * grid.origin_mm);
  low_.setConstant(std::numeric_limits<double>::infinity());
  high_ = -low_;
  for (int k = 0; k < grid.size.z(); ++k)
    for (int j = 0; j < grid.size.y(); ++j)
      for (int i = 0; i < grid.size.x(); ++i) {
        if (values_[static_cast<std::size_t>(grid.offset({i, j, k}))] <= 0.0F) continue;
        const Eigen::Vector3d p = grid.p_in_ct({double(i), double(j), double(k)}).xyz;
        low_ = low_.cwiseMin(p);
        high_ = high_.cwiseMax(p);
      }
}

double ScalarField::at(const Eigen::Vector3d& p_in_ct) const {
  const Eigen::Vector3d index = index_from_ct_ * p_in_ct + offset_;
  // The mesher asks for points so far away that no int holds their cell.
  const auto is_inside = [](double at, int count) { return at >= 0.0 && at < count - 1.0; };
  if (!is_inside(index.x(), grid_.size.x()) || !is_inside(index.y(), grid_.size.y()) ||
      !is_inside(index.z(), grid_.size.z()))
    return -kFar;
  const int i = static_cast<int>(index.x()), j = static_cast<int>(index.y()), k = static_cast<int>(index.z());
  const double u = index.x() - i, v = index.y() - j, w = index.z() - k;
  const long row = grid_.size.x(), slice = row * grid_.size.y();
  const float* c = values_.data() + i + row * j + slice * k;
  const auto along = [&](const float* p) { return p[0] + u * (static_cast<double>(p[1]) - p[0]); };
  const double a = along(c), b = along(c + row), d = along(c + slice), e = along(c + slice + row);
  const double near = a + v * (b - a), far = d + v * (e - d);
  return near + w * (far - near);
}

double ScalarField::volume() const {
  const auto inside = std::count_if(values_.begin(), values_.end(), [](float value) { return value > 0.0F; });
  return static_cast<double>(inside) * grid_.voxel_volume_mm3() * 1e-9;
}

Eigen::Vector3d ScalarField::deepest() const {
  const auto best = std::max_element(values_.begin(), values_.end()) - values_.begin();
  const long row = grid_.size.x(), slice = row * grid_.size.y();
  const long i = best % row, j = best % slice / row, k = best / slice;
  return grid_.p_in_ct({static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)}).xyz;
}

ScalarField resampled(const ScalarField& field, double spacing_mm) {
  Points corners(2, 3);
  corners << field.low().transpose(), field.high().transpose();
  const VolumeGrid grid =
      grid_around(corners, spacing_mm, 2.0 * spacing_mm + field.grid().spacing_mm.maxCoeff());
  std::vector<float> values;
  values.reserve(static_cast<std::size_t>(grid.voxel_count()));
  for (int k = 0; k < grid.size.z(); ++k)
    for (int j = 0; j < grid.size.y(); ++j)
      for (int i = 0; i < grid.size.x(); ++i)
        values.push_back(static_cast<float>(field.at(grid.p_in_ct({double(i), double(j), double(k)}).xyz)));
  return ScalarField(grid, std::move(values));
}

VolumeGrid grid_around(const Points& points, double spacing_mm, double margin_mm) {
  VolumeGrid grid;
  grid.spacing_mm.setConstant(spacing_mm);
  const Eigen::Vector3d low = 1e3 * points.colwise().minCoeff().transpose(),
                        high = 1e3 * points.colwise().maxCoeff().transpose();
  grid.origin_mm = low.array() - margin_mm;
  grid.size = ((high - low).array() + 2.0 * margin_mm)
                  .matrix()
                  .cwiseQuotient(grid.spacing_mm)
                  .array()
                  .ceil()
                  .cast<int>() +
              1;
  return grid;
}

ScalarField field_of_mask(const VolumeGrid& grid, const std::vector<std::uint8_t>& mask,
                          double smoothing_mm) {
  const VoxelBox box = bounding_box(grid.size, grid.spacing_mm, mask, 0.0);
  return field_of_mask(grid, crop(grid.size, grid.spacing_mm, mask, box), box.low, smoothing_mm);
}

ScalarField field_of_mask(const VolumeGrid& grid, const Mask& mask, const Eigen::Vector3i& low,
                          double smoothing_mm) {
  const Eigen::Vector3d sigma = smoothing_mm * grid.spacing_mm.cwiseInverse();
  const VoxelBox box = bounding_box(mask.size, mask.spacing_mm, mask.voxels, 0.0);
  require(!box.empty(), "field_of_mask needs a voxel that is set");
  // The margin may reach out of the image: an organ cut by its edge is closed there.
  const Eigen::Vector3i margin = (3.0 * sigma).array().ceil().cast<int>() + 2;
  const Eigen::Vector3i size = box.size() + 2 * margin;
  const VolumeGrid part = part_of(grid, low + box.low - margin, size);
  std::vector<float> values(static_cast<std::size_t>(part.voxel_count()), 0.0F);
  long count = 0;
  for (int k = box.low.z(); k < box.high.z(); ++k)
    for (int j = box.low.y(); j < box.high.y(); ++j)
      for (int i = box.low.x(); i < box.high.x(); ++i) {
        if (mask.voxels[mask.offset(i, j, k)] == 0) continue;
        values[static_cast<std::size_t>(part.offset(Eigen::Vector3i(i, j, k) - box.low + margin))] = 1.0F;
        ++count;
      }
  for (int axis = 0; axis < 3; ++axis) blur_axis(values, size, axis, sigma[axis]);
  std::vector<float> sorted = values;
  const auto level_at = sorted.end() - count;
  std::nth_element(sorted.begin(), level_at, sorted.end());
  const float above = *level_at, below = *std::max_element(sorted.begin(), level_at);
  const float level = 0.5F * (above + below);
  for (float& value : values) value -= level;
  return ScalarField(part, std::move(values));
}

std::vector<std::uint8_t> voxelise(const TriangleMesh& surface, const VolumeGrid& grid) {
  require(grid.direction.isIdentity(), "voxelise needs a grid along the axes");
  // Rows are moved off the voxel centres by a hair, so that none runs through a vertex or an edge.
  const Eigen::Vector3d hair(0.0, 3.7e-7, 2.3e-7);
  std::vector<std::vector<std::pair<double, int>>> crossings(static_cast<std::size_t>(grid.size.y()) *
                                                             static_cast<std::size_t>(grid.size.z()));
  const auto index = [&](int vertex) -> Eigen::Vector3d {
    return (1e3 * surface.vertex(vertex) - grid.origin_mm).cwiseQuotient(grid.spacing_mm) + hair;
  };
  for (int t = 0; t < surface.triangle_count(); ++t) {
    const Eigen::Vector3d a = index(surface.triangles(t, 0)), b = index(surface.triangles(t, 1)),
                          c = index(surface.triangles(t, 2));
    const double twice_area = (b.y() - a.y()) * (c.z() - a.z()) - (b.z() - a.z()) * (c.y() - a.y());
    if (twice_area == 0.0) continue;
    const Eigen::Vector3d low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
    for (int k = std::max(0, static_cast<int>(std::ceil(low.z())));
         k <= std::min(grid.size.z() - 1.0, high.z()); ++k)
      for (int j = std::max(0, static_cast<int>(std::ceil(low.y())));
           j <= std::min(grid.size.y() - 1.0, high.y()); ++j) {
        const double v = ((j - a.y()) * (c.z() - a.z()) - (k - a.z()) * (c.y() - a.y())) / twice_area;
        const double w = ((b.y() - a.y()) * (k - a.z()) - (b.z() - a.z()) * (j - a.y())) / twice_area;
        if (v < 0.0 || w < 0.0 || v + w > 1.0) continue;
        crossings[static_cast<std::size_t>(j) +
                  static_cast<std::size_t>(grid.size.y()) * static_cast<std::size_t>(k)]
            .emplace_back(a.x() + v * (b.x() - a.x()) + w * (c.x() - a.x()), twice_area > 0.0 ? -1 : 1);
      }
  }
  std::vector<std::uint8_t> inside(static_cast<std::size_t>(grid.voxel_count()), 0);
  for (std::size_t row = 0; row < crossings.size(); ++row) {
    auto& hits = crossings[row];
    std::sort(hits.begin(), hits.end());
    int winding = 0;
    for (std::size_t h = 0; h + 1 < hits.size(); ++h) {
      winding += hits[h].second;
      if (winding == 0) continue;
      const int first = std::max(0, static_cast<int>(std::ceil(hits[h].first)));
      const int last = std::min(grid.size.x() - 1, static_cast<int>(std::floor(hits[h + 1].first)));
      for (int i = first; i <= last; ++i)
        inside[row * static_cast<std::size_t>(grid.size.x()) + static_cast<std::size_t>(i)] = 1;
    }
  }
  return inside;
}

ScalarField field_of_surface(const TriangleMesh& surface, double spacing_mm) {
  const VolumeGrid grid = grid_around(surface.vertices, spacing_mm, 3.0 * spacing_mm);
  const std::vector<std::uint8_t> inside = voxelise(surface, grid);
  std::vector<float> values(inside.size());
  measure_band(surface, grid, inside, values);
  return ScalarField(grid, std::move(values));
}

}  // namespace glisson::model
