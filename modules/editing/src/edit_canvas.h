// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "glisson/core/run_context.h"
#include "glisson/editing/edit.h"
#include "glisson/patient/label_map.h"
#include "glisson/volume/image.h"
#include "glisson/volume/morphology.h"

namespace glisson::editing {

/// A set of structure labels.
class LabelSet {
 public:
  LabelSet() = default;
  LabelSet(std::initializer_list<Label> labels) {
    for (const Label label : labels) insert(label);
  }
  void insert(Label label) {
    if (label < table_.size()) table_[label] = true;
  }
  bool contains(Label label) const { return label < table_.size() && table_[label]; }

 private:
  std::array<bool, structure::kLastLesion + 1> table_{};
};
/// Parenchyma and lesions.
LabelSet liver_tissue();

VoxelBox whole_box(const VolumeGrid& grid);
VoxelBox intersection(const VoxelBox& a, const VoxelBox& b);
/// Grown by so many millimetres (rounded up to voxels) on each side and kept inside. Empty stays empty.
VoxelBox grown(const VoxelBox& box, const VolumeGrid& grid, double margin_mm);
/// The smallest box around the voxels with these labels; empty when there is none.
VoxelBox box_of(const LabelVolume& volume, const LabelSet& labels);

/// The labels in a box, i fastest. @pre box lies inside.
std::vector<Label> labels_in(const LabelVolume& volume, const VoxelBox& box);
Mask mask_in(const LabelVolume& volume, const VoxelBox& box, const LabelSet& labels);

/// Calls visit(brick number, the part of the box that lies in the brick), in memory order, until it returns
/// false. Returns whether it never did.
template <class Visit>
bool for_each_brick_in(const LabelVolume& volume, const VoxelBox& box, Visit&& visit) {
  if (box.empty()) return true;
  constexpr int kSide = LabelVolume::kSide;
  const Eigen::Vector3i first = box.low / kSide, last = (box.high - Eigen::Vector3i::Ones()) / kSide;
  const Eigen::Vector3i& counts = volume.brick_counts();
  for (int z = first.z(); z <= last.z(); ++z)
    for (int y = first.y(); y <= last.y(); ++y)
      for (int x = first.x(); x <= last.x(); ++x) {
        const Eigen::Vector3i low = kSide * Eigen::Vector3i(x, y, z);
        const VoxelBox part{low.cwiseMax(box.low), (low.array() + kSide).matrix().cwiseMin(box.high)};
        const auto number = static_cast<std::size_t>(x) +
                            static_cast<std::size_t>(counts.x()) *
                                (static_cast<std::size_t>(y) +
                                 static_cast<std::size_t>(counts.y()) * static_cast<std::size_t>(z));
        if (!visit(number, part)) return false;
      }
  return true;
}

/// Place of a voxel in its brick.
inline std::size_t in_brick(int i, int j, int k) {
  constexpr int kSide = LabelVolume::kSide;
  return static_cast<std::size_t>((i % kSide) + kSide * ((j % kSide) + kSide * (k % kSide)));
}

/// Says which voxels an edit may change: the editable region, judged on the labels before the edit.
class Gate {
 public:
  /// @param work no voxel outside it will be asked for.
  Gate(const LabelMap& labels, const Image& image, const EditableRegion& region, const VoxelBox& work);
  bool open(int i, int j, int k, Label from, Label to) const { return free_ || judged(i, j, k, from, to); }

 private:
  bool judged(int i, int j, int k, Label from, Label to) const;
  bool in_area(int i, int j, int k, Label from) const;
  void find_liver() const;

  const LabelMap& labels_;
  const Image& image_;
  const EditableRegion& region_;
  VoxelBox work_;
  bool free_ = false;
  LabelSet tissue_;
  /// Found when it is first needed: strokes within the parenchyma never need it.
  mutable std::optional<std::vector<std::uint8_t>> liver_;
  mutable VoxelBox liver_box_;
};

/// Labels being edited. Reads what was there before, writes copies of the bricks that change.
class Canvas {
 public:
  Canvas(const LabelMap& labels, const Image& image, const EditableRegion& region, const VoxelBox& work)
      : before_(labels),
        work_(work),
        gate_(labels, image, region, work),
        mine_(labels.voxels.brick_count()) {}

  const LabelMap& before() const { return before_; }
  const Gate& gate() const { return gate_; }
  const VoxelBox& work() const { return work_; }
  long changed() const { return changed_; }

  /// propose(i, j, k, label before) says what each voxel of a part of one brick shall be. Where the gate is
  /// shut it stays. Proposals for a voxel that is proposed twice must agree.
  template <class Propose>
  void rewrite_part(std::size_t number, const VoxelBox& part, Propose&& propose) {
    const LabelVolume::Brick* old = before_.voxels.brick(number).get();
    for (int k = part.low.z(); k < part.high.z(); ++k)
      for (int j = part.low.y(); j < part.high.y(); ++j) {
        std::size_t at = in_brick(part.low.x(), j, k);
        for (int i = part.low.x(); i < part.high.x(); ++i, ++at) {
          const Label from = old != nullptr ? (*old)[at] : structure::kBackground;
          const Label to = propose(i, j, k, from);
          if (to != from && gate_.open(i, j, k, from, to)) write(number, at, to);
        }
      }
  }
  /// The same for the voxels i0..i1-1 of a row. @pre they lie in the work box.
  template <class Propose>
  void rewrite_row(int j, int k, int i0, int i1, Propose&& propose) {
    if (i0 >= i1) return;
    for_each_brick_in(before_.voxels, {{i0, j, k}, {i1, j + 1, k + 1}},
                      [&](std::size_t number, const VoxelBox& part) {
                        rewrite_part(number, part, propose);
                        return true;
                      });
  }
  /// The same for a box (kept inside the work box), brick by brick. False when cancelled.
  template <class Propose>
  bool rewrite(const VoxelBox& box, const RunContext& context, Propose&& propose) {
    const VoxelBox inside = intersection(box, work_);
    const double slices = std::max(1, inside.size().z());
    return for_each_brick_in(before_.voxels, inside, [&](std::size_t number, const VoxelBox& part) {
      if (context.cancelled()) return false;
      if (part.low.x() == inside.low.x())
        context.progress((part.low.z() - inside.low.z()) / slices, "segmentation.edit");
      rewrite_part(number, part, propose);
      return true;
    });
  }

  /// The labels after it all, with information on the labels that came into being.
  LabelMap finish() const;

 private:
  void write(std::size_t number, std::size_t at, Label label) {
    if (!mine_[number]) {
      const auto& old = before_.voxels.brick(number);
      mine_[number] = old ? std::make_shared<LabelVolume::Brick>(*old)
                          : std::make_shared<LabelVolume::Brick>(LabelVolume::Brick{});
    }
    Label& voxel = (*mine_[number])[at];
    changed_ += voxel != label ? 1 : 0;
    voxel = label;
  }

  const LabelMap& before_;
  VoxelBox work_;
  Gate gate_;
  std::vector<std::shared_ptr<LabelVolume::Brick>> mine_;
  long changed_ = 0;
};

}  // namespace glisson::editing
