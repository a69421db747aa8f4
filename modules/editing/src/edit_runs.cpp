// SPDX-License-Identifier: GPL-3.0-or-later
#include "edit_runs.h"

#include <algorithm>
#include <numeric>

namespace glisson::editing {

Runs::Runs(const Mask& mask, std::uint8_t wanted) : size_(mask.size) {
  const std::size_t rows = static_cast<std::size_t>(size_.y()) * static_cast<std::size_t>(size_.z());
  row_start_.reserve(rows + 1);
  const std::uint8_t* voxel = mask.voxels.data();
  for (std::size_t row = 0; row < rows; ++row, voxel += size_.x()) {
    row_start_.push_back(runs_.size());
    for (int i = 0; i < size_.x();) {
      const int first = i;
      const bool in = (voxel[i] != 0) == (wanted != 0);
      while (i < size_.x() && ((voxel[i] != 0) == (wanted != 0)) == in) ++i;
      if (in) runs_.push_back({first, i, row, 0});
    }
  }
  row_start_.push_back(runs_.size());
  parent_.resize(runs_.size());
  std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  const auto ny = static_cast<std::size_t>(size_.y());
  for (std::size_t row = 0; row < rows; ++row) {
    if (row % ny != 0) join_rows(row, row - 1);
    if (row >= ny) join_rows(row, row - ny);
  }
  number_components();
}

/// Joins the runs of two neighbouring rows that share a face.
void Runs::join_rows(std::size_t row, std::size_t other) {
  std::size_t a = row_start_[row], b = row_start_[other];
  while (a < row_start_[row + 1] && b < row_start_[other + 1]) {
    if (runs_[a].first < runs_[b].end && runs_[b].first < runs_[a].end) {
      const std::size_t root_a = root_of(a), root_b = root_of(b);
      // The earlier one stays the root, so that roots are the first runs of their components.
      parent_[std::max(root_a, root_b)] = std::min(root_a, root_b);
    }
    if (runs_[a].end < runs_[b].end)
      ++a;
    else
      ++b;
  }
}

std::size_t Runs::root_of(std::size_t run) const {
  while (parent_[run] != run) run = parent_[run] = parent_[parent_[run]];
  return run;
}

void Runs::number_components() {
  for (std::size_t n = 0; n < runs_.size(); ++n) {
    const std::size_t root = root_of(n);
    if (root == n) {
      runs_[n].component = sizes_.size();
      sizes_.push_back(0);
    } else {
      runs_[n].component = runs_[root].component;
    }
    sizes_[runs_[n].component] += runs_[n].end - runs_[n].first;
  }
}

std::size_t Runs::component_at(const Eigen::Vector3i& v) const {
  const std::size_t row =
      static_cast<std::size_t>(v.y()) + static_cast<std::size_t>(size_.y()) * static_cast<std::size_t>(v.z());
  for (std::size_t n = row_start_[row]; n < row_start_[row + 1]; ++n)
    if (runs_[n].first <= v.x() && v.x() < runs_[n].end) return runs_[n].component;
  return sizes_.size();
}

std::vector<bool> Runs::at_faces() const {
  std::vector<bool> touching(sizes_.size(), false);
  const auto ny = static_cast<std::size_t>(size_.y()), nz = static_cast<std::size_t>(size_.z());
  for (const Run& run : runs_) {
    const std::size_t j = run.row % ny, k = run.row / ny;
    if (run.first == 0 || run.end == size_.x() || j == 0 || j + 1 == ny || k == 0 || k + 1 == nz)
      touching[run.component] = true;
  }
  return touching;
}

void Runs::write(const std::vector<bool>& chosen, std::uint8_t value, Mask& mask) const {
  for (const Run& run : runs_) {
    if (!chosen[run.component]) continue;
    const auto start =
        mask.voxels.begin() + static_cast<std::ptrdiff_t>(run.row * static_cast<std::size_t>(size_.x()));
    std::fill(start + run.first, start + run.end, value);
  }
}

}  // namespace glisson::editing
