// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <utility>
#include <vector>

#include "glisson/volume/label_volume.h"
#include "glisson/volume/morphology.h"

/// @file
/// How many voxels of each label lie in a ball about a voxel.

namespace glisson::editing {

/// Labels (or a mask as 0 and 1) in a box of the volume.
struct Block {
  VoxelBox box;
  std::vector<Label> labels;

  std::size_t offset(int i, int j, int k) const {
    const Eigen::Vector3i size = box.size();
    return static_cast<std::size_t>(i) +
           static_cast<std::size_t>(size.x()) *
               (static_cast<std::size_t>(j) +
                static_cast<std::size_t>(size.y()) * static_cast<std::size_t>(k));
  }
};

/// A ball as runs along i: those at (j, k) reach `half` voxels to either side.
struct BallRow {
  int j, k, half;
};
std::vector<BallRow> ball_rows(const Eigen::Vector3d& spacing_mm, double radius_mm);

/// Where nothing can change: cells of 8 voxels a side of which all neighbours within the radius hold one and
/// the same label.
class Quiet {
 public:
  Quiet(const Block& block, const Eigen::Vector3d& spacing_mm, double radius_mm);
  bool at(int i, int j, int k) const { return quiet_[place(i / kCell, j / kCell, k / kCell)] != 0; }

 private:
  static constexpr int kCell = 8;
  static constexpr std::int32_t kNothing = -1, kSeveral = -2;
  std::size_t place(int i, int j, int k) const {
    return static_cast<std::size_t>(i) +
           static_cast<std::size_t>(cells_.x()) *
               (static_cast<std::size_t>(j) +
                static_cast<std::size_t>(cells_.y()) * static_cast<std::size_t>(k));
  }
  bool one_label(const std::vector<std::int32_t>& held, const Eigen::Vector3i& cell,
                 const Eigen::Vector3i& reach) const;

  Eigen::Vector3i cells_;
  std::vector<std::uint8_t> quiet_;
};

/// Counts labels in a ball that moves along a row. Balls that reach beyond the block count what is inside.
class Votes {
 public:
  Votes(const Block& block, const std::vector<BallRow>& ball);
  void start_row(int j, int k);
  /// From now on the ball lies about voxel i of the row.
  void move_to(int i);
  /// Of the block, rising.
  const std::vector<Label>& labels() const { return labels_; }
  int count(Label label) const { return count_[label]; }
  /// What most voxels of the ball are; `here` unless another has more.
  Label winner(Label here) const;

 private:
  const Block& block_;
  const std::vector<BallRow>& ball_;
  std::vector<Label> labels_;
  std::vector<int> count_;
  std::vector<std::pair<const Label*, int>> rows_;
  int at_ = -2;
};

}  // namespace glisson::editing
