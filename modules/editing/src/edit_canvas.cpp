// SPDX-License-Identifier: GPL-3.0-or-later
#include "edit_canvas.h"

#include <cmath>
#include <map>

#include "glisson/core/error.h"

namespace glisson::editing {
namespace {

/// Beyond the voxels in question, how far the liver is looked at to say whether they lie in it. Vessels and
/// cavities that are wider than this do not count as enclosed where an edit touches only a part of them.
constexpr double kLiverAround = 20.0;  // mm
/// Of inside_liver(), twice, and a voxel: its closing must see the outside on every side.
constexpr double kLiverMargin = 7.0;  // mm

/// Widens `box` by the voxels of one brick that have one of the labels.
void include_brick(const LabelVolume::Brick& brick, const VoxelBox& part, const LabelSet& labels,
                   VoxelBox& box) {
  for (int k = part.low.z(); k < part.high.z(); ++k)
    for (int j = part.low.y(); j < part.high.y(); ++j) {
      const Label* row = brick.data() + in_brick(part.low.x(), j, k);
      const int length = part.high.x() - part.low.x();
      int first = 0;
      while (first < length && !labels.contains(row[first])) ++first;
      if (first == length) continue;
      int last = length - 1;
      while (!labels.contains(row[last])) --last;
      box.low = box.low.cwiseMin(Eigen::Vector3i(part.low.x() + first, j, k));
      box.high = box.high.cwiseMax(Eigen::Vector3i(part.low.x() + last + 1, j + 1, k + 1));
    }
}

/// Calls row(labels of a row or null, first offset in a box-sized array, length) for every row of the bricks
/// that meet the box.
template <class Row>
void for_each_row_in(const LabelVolume& volume, const VoxelBox& box, Row&& row) {
  const Eigen::Vector3i size = box.size();
  for_each_brick_in(volume, box, [&](std::size_t number, const VoxelBox& part) {
    const LabelVolume::Brick* brick = volume.brick(number).get();
    if (brick == nullptr) return true;
    for (int k = part.low.z(); k < part.high.z(); ++k)
      for (int j = part.low.y(); j < part.high.y(); ++j) {
        const std::size_t to =
            static_cast<std::size_t>(part.low.x() - box.low.x()) +
            static_cast<std::size_t>(size.x()) *
                (static_cast<std::size_t>(j - box.low.y()) +
                 static_cast<std::size_t>(size.y()) * static_cast<std::size_t>(k - box.low.z()));
        row(brick->data() + in_brick(part.low.x(), j, k), to, part.high.x() - part.low.x());
      }
    return true;
  });
}

std::size_t voxels_of(const VoxelBox& box) {
  const Eigen::Vector3i size = box.size();
  return static_cast<std::size_t>(size.x()) * static_cast<std::size_t>(size.y()) *
         static_cast<std::size_t>(size.z());
}

}  // namespace

LabelSet liver_tissue() {
  LabelSet tissue{structure::kParenchyma};
  for (int label = structure::kFirstLesion; label <= structure::kLastLesion; ++label)
    tissue.insert(static_cast<Label>(label));
  return tissue;
}

VoxelBox whole_box(const VolumeGrid& grid) { return {Eigen::Vector3i::Zero(), grid.size}; }

VoxelBox intersection(const VoxelBox& a, const VoxelBox& b) {
  const VoxelBox both{a.low.cwiseMax(b.low), a.high.cwiseMin(b.high)};
  return both.empty() ? VoxelBox{} : both;
}

VoxelBox grown(const VoxelBox& box, const VolumeGrid& grid, double margin_mm) {
  if (box.empty()) return {};
  const Eigen::Vector3i margin = (margin_mm / grid.spacing_mm.array()).ceil().min(1e6).matrix().cast<int>();
  return intersection({box.low - margin, box.high + margin}, whole_box(grid));
}

VoxelBox box_of(const LabelVolume& volume, const LabelSet& labels) {
  if (labels.contains(structure::kBackground)) return whole_box(volume.grid());
  VoxelBox box{volume.grid().size, Eigen::Vector3i::Zero()};
  for_each_brick_in(volume, whole_box(volume.grid()), [&](std::size_t number, const VoxelBox& part) {
    const bool known =
        (part.low.array() >= box.low.array()).all() && (part.high.array() <= box.high.array()).all();
    if (volume.brick(number) && !known) include_brick(*volume.brick(number), part, labels, box);
    return true;
  });
  return box.empty() ? VoxelBox{} : box;
}

std::vector<Label> labels_in(const LabelVolume& volume, const VoxelBox& box) {
  std::vector<Label> values(voxels_of(box), structure::kBackground);
  for_each_row_in(volume, box, [&](const Label* from, std::size_t to, int length) {
    std::copy(from, from + length, values.begin() + static_cast<std::ptrdiff_t>(to));
  });
  return values;
}

Mask mask_in(const LabelVolume& volume, const VoxelBox& box, const LabelSet& labels) {
  Mask mask(box.size(), volume.grid().spacing_mm);
  if (labels.contains(structure::kBackground))
    std::fill(mask.voxels.begin(), mask.voxels.end(), std::uint8_t{1});
  for_each_row_in(volume, box, [&](const Label* from, std::size_t to, int length) {
    std::transform(from, from + length, mask.voxels.begin() + static_cast<std::ptrdiff_t>(to),
                   [&](Label label) { return labels.contains(label) ? 1 : 0; });
  });
  return mask;
}

Gate::Gate(const LabelMap& labels, const Image& image, const EditableRegion& region, const VoxelBox& work)
    : labels_(labels), image_(image), region_(region), work_(work), tissue_(liver_tissue()) {
  free_ = region.area == EditableRegion::Area::everywhere && !region.intensity && region.locked.empty();
}

bool Gate::judged(int i, int j, int k, Label from, Label to) const {
  for (const Label locked : region_.locked)
    if (locked == from || locked == to) return false;
  if (region_.intensity) {
    const double intensity = image_.at({i, j, k});
    if (intensity < (*region_.intensity)[0] || intensity > (*region_.intensity)[1]) return false;
  }
  return in_area(i, j, k, from);
}

bool Gate::in_area(int i, int j, int k, Label from) const {
  using Area = EditableRegion::Area;
  switch (region_.area) {
    case Area::everywhere:
      return true;
    case Area::labelled:
      return from != structure::kBackground;
    case Area::unlabelled:
      return from == structure::kBackground;
    case Area::inside_label:
      return from == region_.label;
    case Area::inside_liver:
      break;
  }
  if (tissue_.contains(from)) return true;
  if (!liver_) find_liver();
  const Eigen::Vector3i v = Eigen::Vector3i(i, j, k) - liver_box_.low;
  const Eigen::Vector3i size = liver_box_.size();
  if ((v.array() < 0).any() || (v.array() >= size.array()).any()) return false;
  return (*liver_)[static_cast<std::size_t>(v.x()) +
                   static_cast<std::size_t>(size.x()) *
                       (static_cast<std::size_t>(v.y()) +
                        static_cast<std::size_t>(size.y()) * static_cast<std::size_t>(v.z()))] != 0;
}

void Gate::find_liver() const {
  const VolumeGrid& grid = labels_.voxels.grid();
  const VoxelBox tissue = grown(box_of(labels_.voxels, tissue_), grid, kLiverMargin);
  liver_box_ = intersection(tissue, grown(work_, grid, kLiverAround));
  liver_.emplace();
  if (liver_box_.empty()) return;
  VolumeGrid part = grid;
  part.size = liver_box_.size();
  liver_ = inside_liver({LabelVolume(part, labels_in(labels_.voxels, liver_box_)), {}});
}

LabelMap Canvas::finish() const {
  LabelMap after = before_;
  std::array<bool, structure::kLastLesion + 1> present{};
  std::map<Label, std::shared_ptr<const LabelVolume::Brick>> uniform;
  for (std::size_t number = 0; number < mine_.size(); ++number) {
    if (!mine_[number]) continue;
    const LabelVolume::Brick& brick = *mine_[number];
    for (const Label label : brick)
      if (label < present.size()) present[label] = true;
    const bool one = std::all_of(brick.begin(), brick.end(), [&](Label label) { return label == brick[0]; });
    std::shared_ptr<const LabelVolume::Brick> content = mine_[number];
    // Bricks of one label are shared, and those of zeros none: filling a volume costs one brick.
    if (one && brick[0] == structure::kBackground)
      content = nullptr;
    else if (one)
      content = uniform.try_emplace(brick[0], content).first->second;
    after.voxels.set_brick(number, std::move(content));
  }
  for (std::size_t label = 1; label < present.size(); ++label) {
    if (!present[label]) continue;
    // Files list their segments in any order.
    if (std::ranges::find(after.infos, static_cast<Label>(label), &LabelInfo::code) != after.infos.end())
      continue;
    const auto place = std::ranges::find_if(
        after.infos, [&](const LabelInfo& info) { return static_cast<std::size_t>(info.code) > label; });
    after.infos.insert(place, structure_info(static_cast<Label>(label)));
  }
  return after;
}

}  // namespace glisson::editing
