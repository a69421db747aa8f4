// SPDX-License-Identifier: GPL-3.0-or-later
#include "oriented.h"

#include <algorithm>
#include <cmath>

namespace glisson::network {
namespace {

/// LPS.
Eigen::Vector3d direction_of(char letter) {
  switch (letter) {
    case 'L':
      return Eigen::Vector3d::UnitX();
    case 'R':
      return -Eigen::Vector3d::UnitX();
    case 'P':
      return Eigen::Vector3d::UnitY();
    case 'A':
      return -Eigen::Vector3d::UnitY();
    case 'S':
      return Eigen::Vector3d::UnitZ();
    default:
      return -Eigen::Vector3d::UnitZ();
  }
}

/// Which of the volume's axes is nearest to each that is asked for; none is taken twice.
Three nearest_axes(const Eigen::Matrix3d& wanted, const Eigen::Matrix3d& direction) {
  Three order = {0, 1, 2}, best = order;
  double most = -1.0;
  do {
    double sum = 0.0;
    for (int n = 0; n < 3; ++n)
      sum += std::abs(wanted.col(n).dot(direction.col(order[static_cast<std::size_t>(n)])));
    if (sum > most + 1e-9) {
      most = sum;
      best = order;
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return best;
}

}  // namespace

Oriented::Oriented(const VolumeGrid& grid, const std::string& axes, const std::vector<double>& spacing_mm) {
  Eigen::Matrix3d wanted;
  for (int n = 0; n < 3; ++n) wanted.col(n) = direction_of(axes[static_cast<std::size_t>(n)]);
  const Three order = nearest_axes(wanted, grid.direction);
  const std::array<long, 3> strides = {1, grid.size.x(), static_cast<long>(grid.size.x()) * grid.size.y()};
  const std::size_t given = spacing_mm.size();
  for (std::size_t n = 0; n < 3; ++n) {
    const int axis = order[n];
    const auto own = static_cast<Eigen::Index>(n);
    volume_size_[n] = grid.size[axis];
    const long stride = strides[static_cast<std::size_t>(axis)];
    const bool flipped = wanted.col(own).dot(grid.direction.col(axis)) < 0.0;
    steps_[n] = flipped ? -stride : stride;
    if (flipped) first_ += static_cast<std::size_t>(stride * (volume_size_[n] - 1));
    // Two numbers are rows and columns.
    const bool asked = n + given >= 3;
    scale_[n] = asked ? spacing_mm[n + given - 3] / grid.spacing_mm[axis] : 1.0;
    size_[n] = std::max(1, static_cast<int>(std::lround(volume_size_[n] / scale_[n])));
  }
}

double Oriented::volume_place(int axis, double voxel) const {
  const auto n = static_cast<std::size_t>(axis);
  return std::clamp((voxel + 0.5) * scale_[n] - 0.5, 0.0, static_cast<double>(volume_size_[n] - 1));
}

double Oriented::network_place(int axis, double voxel) const {
  const auto n = static_cast<std::size_t>(axis);
  return std::clamp((voxel + 0.5) / scale_[n] - 0.5, 0.0, static_cast<double>(size_[n] - 1));
}

Between between(double place, int count) {
  const int low = std::min(static_cast<int>(place), count - 1);
  return {low, std::min(low + 1, count - 1), static_cast<float>(place - low)};
}

std::vector<float> sampled(const Image& image, const Oriented& oriented, const Three& first,
                           const Three& size) {
  std::array<std::vector<Between>, 3> places;
  for (std::size_t n = 0; n < 3; ++n)
    for (int voxel = 0; voxel < size[n]; ++voxel)
      places[n].push_back(
          between(oriented.volume_place(static_cast<int>(n), first[n] + voxel), oriented.volume_size()[n]));
  const std::vector<std::int16_t>& voxels = *image.voxels;
  const auto line = [&](int slice, int row, const Between& column) {
    const float low = voxels[oriented.offset(slice, row, column.low)];
    return column.part == 0.0F ? low
                               : low + column.part * (voxels[oriented.offset(slice, row, column.high)] - low);
  };
  const auto plane = [&](int slice, const Between& row, const Between& column) {
    const float low = line(slice, row.low, column);
    return row.part == 0.0F ? low : low + row.part * (line(slice, row.high, column) - low);
  };
  std::vector<float> values;
  values.reserve(places[0].size() * places[1].size() * places[2].size());
  for (const Between& slice : places[0])
    for (const Between& row : places[1])
      for (const Between& column : places[2]) {
        const float low = plane(slice.low, row, column);
        values.push_back(slice.part == 0.0F ? low
                                            : low + slice.part * (plane(slice.high, row, column) - low));
      }
  return values;
}

}  // namespace glisson::network
