// SPDX-License-Identifier: GPL-3.0-or-later
#include "tissue_map.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace glisson::guidance {
namespace {

constexpr double kCell = 4e-3;    ///< metres; a registration thins to 5 mm
constexpr int kLeastLooks = 3;    ///< what is seen there once passes by
constexpr int kRemembered = 200;  ///< points of a cell: older ones fade, as the organ goes on changing

/// 21 bits an axis, within 4 km of the camera.
std::uint64_t cell_of(const Eigen::Vector3d& p) {
  std::uint64_t key = 0;
  for (int k = 0; k < 3; ++k)
    key = key << 21 | (static_cast<std::uint64_t>(std::floor(p[k] / kCell) + (1 << 20)) & 0x1fffff);
  return key;
}

}  // namespace

void TissueMap::add(const std::vector<Eigen::Vector3d>& places, const Eigen::Vector3d& eye) {
  ++looks_;
  for (const Eigen::Vector3d& place : places) {
    Cell& cell = cells_[cell_of(place)];
    cell.points = std::min(cell.points + 1, kRemembered);
    cell.mean += (place - cell.mean) / cell.points;
    cell.eye += (eye - cell.eye) / cell.points;
    cell.looks += cell.last_look != looks_;
    cell.last_look = looks_;
  }
}

LabelledCloud TissueMap::places() const {
  std::vector<std::pair<std::uint64_t, const Cell*>> kept;
  for (const auto& [key, cell] : cells_)
    if (cell.looks >= kLeastLooks) kept.emplace_back(key, &cell);
  std::sort(kept.begin(), kept.end());
  LabelledCloud places;
  places.points.resize(static_cast<Eigen::Index>(kept.size()), 3);
  places.seen_from.resize(places.points.rows(), 3);
  for (Eigen::Index i = 0; i < places.points.rows(); ++i) {
    const Cell& cell = *kept[static_cast<std::size_t>(i)].second;
    places.points.row(i) = cell.mean.transpose();
    places.seen_from.row(i) = cell.eye.transpose();
  }
  return places;
}

void TissueMap::clear() {
  cells_.clear();
  looks_ = 0;
}

}  // namespace glisson::guidance
