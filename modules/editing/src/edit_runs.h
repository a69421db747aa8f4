// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "glisson/volume/morphology.h"

namespace glisson::editing {

/// The voxels of a mask as runs along i, joined through faces into components. Far smaller than a number for
/// each voxel, and a liver has some hundred thousand runs.
class Runs {
 public:
  struct Run {
    int first = 0, end = 0;  ///< voxels first..end-1 of its row
    std::size_t row = 0;     ///< j + size.y * k
    std::size_t component = 0;
  };
  /// @param wanted 1: runs of the voxels that are set, 0: of the others.
  Runs(const Mask& mask, std::uint8_t wanted);

  const std::vector<Run>& runs() const { return runs_; }
  /// Voxels of each component; their order is that of their first voxels in memory.
  const std::vector<long>& sizes() const { return sizes_; }
  /// The component of a voxel, or sizes().size() when it is in none.
  std::size_t component_at(const Eigen::Vector3i& v) const;
  /// Whether each component reaches the faces of the box.
  std::vector<bool> at_faces() const;
  /// Writes `value` into `mask` for the voxels of the components that `chosen` says.
  void write(const std::vector<bool>& chosen, std::uint8_t value, Mask& mask) const;

 private:
  void join_rows(std::size_t row, std::size_t other);
  std::size_t root_of(std::size_t run) const;
  void number_components();

  Eigen::Vector3i size_;
  std::vector<Run> runs_;
  std::vector<std::size_t> row_start_;  ///< first run of each row, and one past the last
  mutable std::vector<std::size_t> parent_;
  std::vector<long> sizes_;
};

}  // namespace glisson::editing
