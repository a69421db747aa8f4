// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "glisson/volume/grid.h"

namespace glisson {

using Label = std::uint16_t;

struct LabelChange;
/// What an edit did, brick by brick.
using LabelChanges = std::vector<LabelChange>;

/// Labels as persistent bricks of 32 voxels a side, shared until written: copying a volume copies pointers,
/// an edit copies only the bricks that it touches. That is what makes snapshots and undo cheap. Not
/// thread-safe to write; copies may be read from anywhere.
class LabelVolume {
 public:
  static constexpr int kSide = 32;
  using Brick = std::array<Label, kSide * kSide * kSide>;

  LabelVolume() = default;
  /// All zero; no brick is allocated.
  explicit LabelVolume(const VolumeGrid& grid);
  /// From a dense array, i fastest. @pre as many values as voxels.
  LabelVolume(const VolumeGrid& grid, const std::vector<Label>& dense);

  const VolumeGrid& grid() const { return grid_; }
  bool empty() const { return grid_.voxel_count() == 0; }

  /// @pre grid().contains(v)
  Label at(const Eigen::Vector3i& v) const;
  /// Copies the brick first if another volume shares it. @pre grid().contains(v)
  void set(const Eigen::Vector3i& v, Label label);

  /// A copy of all voxels, i fastest: large.
  std::vector<Label> dense() const;
  /// Dense 0/1 mask of the voxels whose label satisfies `wanted`.
  std::vector<std::uint8_t> mask(const std::function<bool(Label)>& wanted) const;
  /// Voxels of each label present, by label.
  std::vector<long> histogram() const;

  /// How many bricks the two volumes do not share (for tests of sharing, and to update only what changed).
  int bricks_differing_from(const LabelVolume& other) const;
  bool operator==(const LabelVolume& other) const;

  /// Bricks along each axis, i fastest in their numbering. A brick's first voxel is kSide times its place.
  const Eigen::Vector3i& brick_counts() const { return bricks_; }
  std::size_t brick_count() const { return brick_.size(); }
  /// Counted in bricks along i, j, k. @pre number < brick_count()
  Eigen::Vector3i brick_place(std::size_t number) const;
  /// Null: all zero. What lies beyond the volume in the last bricks of an axis is zero.
  const std::shared_ptr<const Brick>& brick(std::size_t number) const { return brick_[number]; }
  /// Puts a brick in place without copying it. @param brick zero beyond the volume; null: all zero.
  /// @pre number < brick_count()
  void set_brick(std::size_t number, std::shared_ptr<const Brick> brick);
  /// The bricks that are not shared with `before` and differ. @pre one grid.
  LabelChanges changes_since(const LabelVolume& before) const;
  /// Puts the changes' bricks in place: `after`, or `before` where `back`.
  void apply(const LabelChanges& changes, bool back);

 private:
  std::size_t brick_of(const Eigen::Vector3i& v) const;

  VolumeGrid grid_;
  Eigen::Vector3i bricks_ = Eigen::Vector3i::Zero();
  std::vector<std::shared_ptr<const Brick>> brick_;  ///< null: all zero
};

/// One brick that an edit changed.
struct LabelChange {
  std::size_t number = 0;                                   ///< of the brick
  std::shared_ptr<const LabelVolume::Brick> before, after;  ///< null: all zero
};

}  // namespace glisson
