// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/patient/lesion_pieces.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "glisson/volume/brick_voxels.h"
#include "glisson/volume/morphology.h"

namespace glisson {
namespace {

/// The voxels of one label, by piece.
std::vector<std::vector<Eigen::Vector3i>> pieces_of(const LabelVolume& labels, Label lesion) {
  std::vector<Eigen::Vector3i> voxels;
  each_voxel(labels, lesion, [&](const Eigen::Vector3i& v) { voxels.push_back(v); });
  if (voxels.empty()) return {};
  const VolumeGrid& grid = labels.grid();
  // Two balls of half the distance touch. Of thick slices up to two may be empty in between.
  const double reach = std::max(0.5 * kOneLesionMm, grid.spacing_mm.maxCoeff());
  const Eigen::Vector3i margin = (reach / grid.spacing_mm.array()).ceil().cast<int>() + 1;
  Eigen::Vector3i low = voxels.front(), high = low;
  for (const Eigen::Vector3i& v : voxels) low = low.cwiseMin(v), high = high.cwiseMax(v);
  low -= margin;
  Mask mask(high - low + margin + Eigen::Vector3i::Ones(), grid.spacing_mm);
  const auto offset = [&](const Eigen::Vector3i& v) {
    const Eigen::Vector3i at = v - low;
    return mask.offset(at.x(), at.y(), at.z());
  };
  for (const Eigen::Vector3i& v : voxels) mask.voxels[offset(v)] = 1;
  std::vector<long> sizes;
  const std::vector<int> joined = connected_components(dilated(mask, reach), sizes);
  std::vector<std::vector<Eigen::Vector3i>> pieces(sizes.size());
  for (const Eigen::Vector3i& v : voxels)
    pieces[static_cast<std::size_t>(joined[offset(v)]) - 1].push_back(v);
  std::ranges::stable_sort(pieces, [](const auto& a, const auto& b) { return a.size() > b.size(); });
  return pieces;
}

void add_info(LabelMap& labels, Label lesion, Label piece) {
  LabelInfo info = structure_info(piece);
  const auto known = std::ranges::find(labels.infos, lesion, &LabelInfo::code);
  if (known != labels.infos.end()) info.terminology = known->terminology;
  std::erase_if(labels.infos, [piece](const LabelInfo& old) { return old.code == piece; });
  labels.infos.push_back(std::move(info));
}

}  // namespace

std::vector<long> lesion_pieces(const LabelVolume& labels, Label lesion) {
  std::vector<long> sizes;
  for (const auto& piece : pieces_of(labels, lesion)) sizes.push_back(static_cast<long>(piece.size()));
  return sizes;
}

std::vector<LesionSplit> split_lesions(LabelMap& labels) {
  std::vector<LesionSplit> splits;
  const std::vector<long> counts = labels.voxels.histogram();
  const std::vector<Label> free = free_labels(
      structure::kFirstLesion, [&counts](Label label) { return label < counts.size() && counts[label] > 0; });
  auto next = free.begin();
  for (std::size_t code = structure::kFirstLesion; code < counts.size(); ++code) {
    const auto lesion = static_cast<Label>(code);
    if (counts[code] == 0 || !is_lesion(lesion)) continue;
    const auto pieces = pieces_of(labels.voxels, lesion);
    if (pieces.size() < 2) continue;
    LesionSplit split{lesion, {}, 0};
    for (std::size_t n = 1; n < pieces.size(); ++n) {
      if (next == free.end()) {
        ++split.left;
        continue;
      }
      for (const Eigen::Vector3i& v : pieces[n]) labels.voxels.set(v, *next);
      add_info(labels, lesion, *next);
      split.others.push_back(*next++);
    }
    splits.push_back(std::move(split));
  }
  return splits;
}

}  // namespace glisson
