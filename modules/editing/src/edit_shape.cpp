// SPDX-License-Identifier: GPL-3.0-or-later
#include "edit_shape.h"

#include <cmath>

#include "glisson/volume/voxel_neighbours.h"

namespace glisson::editing {
namespace {

constexpr double kBesideMm = 12.0;  ///< how far what is erased looks for what it becomes

}  // namespace

LabelSet shape_of(Label label) {
  if (label != structure::kParenchyma) return {label};
  LabelSet shape = liver_tissue();
  for (const Label vessel : {structure::kPortalVein, structure::kHepaticVeins, structure::kArtery})
    shape.insert(vessel);
  return shape;
}

bool may_gain(Label label, Label from) {
  return from == structure::kBackground ||
         (from == structure::kParenchyma && label != structure::kParenchyma);
}

std::vector<Label> given_away(const Mask& lost, const std::vector<Label>& before, Label label) {
  std::vector<Label> after(lost.voxels.size(), structure::kBackground);
  if (label == structure::kParenchyma) return after;
  // Fronts from both, a step at a time; within one step the parenchyma goes first.
  std::vector<std::uint8_t> taken(lost.voxels.size(), 0);
  std::vector<std::size_t> front[2], next;
  const std::array<Label, 2> owners = {structure::kParenchyma, structure::kBackground};
  const auto take = [&](std::size_t at, std::size_t side, std::vector<std::size_t>& into) {
    if (lost.voxels[at] == 0 || taken[at] != 0) return;
    taken[at] = 1;
    after[at] = owners[side];
    into.push_back(at);
  };
  for (const std::size_t side : {0U, 1U})
    for (std::size_t at = 0; at < lost.voxels.size(); ++at) {
      if (lost.voxels[at] == 0 || taken[at] != 0) continue;
      bool touches = false;
      each_face_neighbour(lost.size, at, [&](std::size_t beside, int) {
        touches = touches || (lost.voxels[beside] == 0 && before[beside] == owners[side]);
      });
      if (touches) take(at, side, front[side]);
    }
  while (!front[0].empty() || !front[1].empty())
    for (const std::size_t side : {0U, 1U}) {
      next.clear();
      for (const std::size_t at : front[side])
        each_face_neighbour(lost.size, at, [&](std::size_t beside, int) { take(beside, side, next); });
      front[side].swap(next);
    }
  return after;
}

bool lies_in_liver(Label label) {
  return is_lesion(label) || label == structure::kPortalVein || label == structure::kHepaticVeins ||
         label == structure::kArtery;
}

Surroundings::Surroundings(const LabelVolume& labels, const VoxelBox& work)
    : box_(grown(work, labels.grid(), kBesideMm)) {
  to_tissue_ = squared_distance_mm2(mask_in(labels, box_, {structure::kParenchyma}));
  to_background_ = squared_distance_mm2(mask_in(labels, box_, {structure::kBackground}));
}

Label Surroundings::at(int i, int j, int k) const {
  const Eigen::Vector3i size = box_.size();
  const auto n = static_cast<std::size_t>(
      i - box_.low.x() +
      static_cast<long>(size.x()) * (j - box_.low.y() + static_cast<long>(size.y()) * (k - box_.low.z())));
  return std::isfinite(to_tissue_[n]) && to_tissue_[n] <= to_background_[n] ? structure::kParenchyma
                                                                            : structure::kBackground;
}

bool take_away(Canvas& canvas, const std::vector<Eigen::Vector3i>& lost, Label label,
               const RunContext& context) {
  if (lost.empty()) return true;
  VoxelBox box{lost.front(), lost.front() + Eigen::Vector3i::Ones()};
  for (const Eigen::Vector3i& v : lost) {
    box.low = box.low.cwiseMin(v);
    box.high = box.high.cwiseMax(v + Eigen::Vector3i::Ones());
  }
  std::optional<Surroundings> beside;
  if (lies_in_liver(label)) beside.emplace(canvas.before().voxels, box);
  if (context.cancelled()) return false;
  for (const Eigen::Vector3i& v : lost)
    canvas.rewrite_row(v.y(), v.z(), v.x(), v.x() + 1, [&](int i, int j, int k, Label) {
      return beside ? beside->at(i, j, k) : structure::kBackground;
    });
  context.progress(1.0, "segmentation.edit");
  return true;
}

bool reshape(Canvas& canvas, const VoxelBox& box, const Mask& after, Label label, const RunContext& context) {
  const std::vector<Label> before = labels_in(canvas.before().voxels, box);
  Mask lost(after.size, after.spacing_mm);
  for (std::size_t at = 0; at < before.size(); ++at)
    lost.voxels[at] = before[at] == label && after.voxels[at] == 0 ? 1 : 0;
  if (context.cancelled()) return false;
  const std::vector<Label> given = given_away(lost, before, label);
  return canvas.rewrite(box, context, [&](int i, int j, int k, Label old) {
    const std::size_t at = after.offset(i - box.low.x(), j - box.low.y(), k - box.low.z());
    if (lost.voxels[at] != 0) return given[at];
    return after.voxels[at] != 0 && may_gain(label, old) ? label : old;
  });
}

}  // namespace glisson::editing
