// SPDX-License-Identifier: GPL-3.0-or-later
#include "part.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace glisson::segmentation {
namespace {

VolumeGrid part_of(const VolumeGrid& grid, const VoxelBox& box) {
  VolumeGrid part = grid;
  part.size = box.size();
  part.origin_mm = 1e3 * grid.p_in_ct(box.low.cast<double>()).xyz;
  return part;
}

}  // namespace

bool holds(const VolumeGrid& image, const Eigen::Vector3d& p_in_ct) {
  const Eigen::Vector3d index = image.index_of(Point<CtFrame>(p_in_ct));
  return index.allFinite() && image.contains(index.array().round().max(-1.0).min(1e6).matrix().cast<int>());
}

VoxelBox box_of(const VolumeGrid& grid, const std::optional<Eigen::AlignedBox3d>& region) {
  VoxelBox box{Eigen::Vector3i::Zero(), grid.size};
  if (!region) return box;
  Eigen::AlignedBox3d indices;
  for (int corner = 0; corner < 8; ++corner)
    indices.extend(
        grid.index_of(Point<CtFrame>(region->corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)))));
  for (int axis = 0; axis < 3; ++axis) {
    const double last = grid.size[axis];
    box.low[axis] = static_cast<int>(std::clamp(std::ceil(indices.min()[axis]), 0.0, last));
    box.high[axis] = static_cast<int>(std::clamp(std::floor(indices.max()[axis]) + 1.0, 0.0, last));
  }
  return box;
}

bool is_in(const std::optional<Eigen::AlignedBox3d>& region, const VolumeGrid& grid,
           const Eigen::Vector3i& voxel) {
  constexpr double kRounding = 1e-9;  // metres
  return !region ||
         region->squaredExteriorDistance(grid.p_in_ct(voxel.cast<double>()).xyz) <= kRounding * kRounding;
}

bool is_among(const std::vector<Label>& labels, Label label) {
  return std::find(labels.begin(), labels.end(), label) != labels.end();
}

bool is_in_liver(Label label) {
  return is_liver_tissue(label) || label == structure::kPortalVein || label == structure::kHepaticVeins ||
         label == structure::kArtery;
}

void name_structure(Label structure, LabelMap& labels) {
  if (std::none_of(labels.infos.begin(), labels.infos.end(),
                   [&](const LabelInfo& info) { return info.code == structure; }))
    labels.infos.push_back(structure_info(structure));
}

Image part_of(const Image& image, const VoxelBox& box) {
  if (box.size() == image.grid.size) return image;
  Image part = image;
  part.grid = part_of(image.grid, box);
  std::vector<std::int16_t> voxels;
  voxels.reserve(static_cast<std::size_t>(part.grid.voxel_count()));
  for (int k = box.low.z(); k < box.high.z(); ++k)
    for (int j = box.low.y(); j < box.high.y(); ++j) {
      const auto row = image.voxels->begin() + image.grid.offset({box.low.x(), j, k});
      voxels.insert(voxels.end(), row, row + box.size().x());
    }
  part.voxels = std::make_shared<const std::vector<std::int16_t>>(std::move(voxels));
  return part;
}

LabelMap part_of(const LabelMap& labels, const VoxelBox& box) {
  if (box.size() == labels.voxels.grid().size) return labels;
  std::vector<Label> dense;
  for (int k = box.low.z(); k < box.high.z(); ++k)
    for (int j = box.low.y(); j < box.high.y(); ++j)
      for (int i = box.low.x(); i < box.high.x(); ++i) dense.push_back(labels.voxels.at({i, j, k}));
  return {LabelVolume(part_of(labels.voxels.grid(), box), dense), labels.infos};
}

std::optional<Eigen::Vector3i> voxel_in(const VolumeGrid& part,
                                        const std::optional<Eigen::AlignedBox3d>& region,
                                        const Eigen::Vector3d& p_in_ct) {
  const Eigen::Vector3d index = part.index_of(Point<CtFrame>(p_in_ct));
  const Eigen::Vector3i voxel = index.array().round().matrix().cast<int>();
  return part.contains(voxel) && is_in(region, part, voxel) ? std::optional(voxel) : std::nullopt;
}

Seeds part_of(const Seeds& seeds, const VolumeGrid& part, const std::optional<Eigen::AlignedBox3d>& region) {
  const auto inside = [&](const Points& points) {
    std::vector<Eigen::Index> rows;
    for (Eigen::Index n = 0; n < points.rows(); ++n)
      if (voxel_in(part, region, points.row(n).transpose())) rows.push_back(n);
    return Points(points(rows, Eigen::all));
  };
  Seeds result{inside(seeds.liver),         inside(seeds.portal_vein),
               inside(seeds.hepatic_veins), inside(seeds.vena_cava),
               inside(seeds.gallbladder),   {},
               inside(seeds.background),    {}};
  for (const Points& lesion : seeds.lesions) result.lesions.push_back(inside(lesion));
  result.lesion_diameters_mm = seeds.lesion_diameters_mm;
  return result;
}

VoxelBox box_around(const VolumeGrid& image, const Points& points, double reach_mm) {
  VoxelBox box{image.size, Eigen::Vector3i::Zero()};
  const Eigen::Vector3d reach = reach_mm * image.spacing_mm.cwiseInverse();
  for (Eigen::Index n = 0; n < points.rows(); ++n) {
    const Eigen::Vector3d at = image.index_of(Point<CtFrame>(Eigen::Vector3d(points.row(n).transpose())));
    box.low = box.low.cwiseMin((at - reach).array().floor().matrix().cast<int>());
    box.high = box.high.cwiseMax((at + reach).array().ceil().matrix().cast<int>());
  }
  box.low = box.low.cwiseMax(0);
  box.high = box.high.cwiseMin(image.size);
  return box;
}

}  // namespace glisson::segmentation
