// SPDX-License-Identifier: GPL-3.0-or-later
#include "bites.h"

namespace glisson::segmentation {
namespace {

constexpr double kHollow = 50.0;  // mm: a tumour at the rim is a bite of up to this radius
constexpr double kDeep = 10.0;    // mm: of a bite out of which something may bulge
constexpr double kBulge = 20.0;   // mm beyond the mouth of such a bite

/// Copies between a volume and a box of it that may reach beyond it; `copy` takes the offsets in both.
template <class Copy>
void each_shared(const Mask& whole, const Mask& part, const Eigen::Vector3i& low, const Copy& copy) {
  const Eigen::Vector3i first = (-low).cwiseMax(0), end = (whole.size - low).cwiseMin(part.size);
  for (int k = first.z(); k < end.z(); ++k)
    for (int j = first.y(); j < end.y(); ++j)
      for (int i = first.x(); i < end.x(); ++i)
        copy(whole.offset(i + low.x(), j + low.y(), k + low.z()), part.offset(i, j, k));
}

Mask both(Mask a, const Mask& b) {
  for (std::size_t i = 0; i < a.voxels.size(); ++i) a.voxels[i] = a.voxels[i] != 0 && b.voxels[i] != 0;
  return a;
}

/// Adds what may bulge out of the deep bites of a hull.
void add_bulges(Mask& hull, const Mask& liver) {
  const std::vector<float> depth2 = squared_depth_mm2(hull);
  const Mask bites = both(hull, complement(liver));
  Mask deep = bites;
  for (std::size_t i = 0; i < deep.voxels.size(); ++i)
    if (static_cast<double>(depth2[i]) < kDeep * kDeep) deep.voxels[i] = 0;
  if (deep.count() == 0) return;
  const Mask to_their_mouths = both(dilated(deep, 2.0 * kDeep), bites),
             bulge = dilated(to_their_mouths, kBulge);
  for (std::size_t i = 0; i < bulge.voxels.size(); ++i)
    if (bulge.voxels[i] != 0) hull.voxels[i] = 1;
}

}  // namespace

Mask with_bites(const Mask& liver) {
  const VoxelBox box = bounding_box(liver.size, liver.spacing_mm, liver.voxels, 0.0);
  if (box.empty()) return liver;
  // With room on all sides: what lies beyond a volume counts as part of it in an erosion.
  const Eigen::Vector3i room =
      (liver.spacing_mm.cwiseInverse() * (kHollow + 1.0)).array().ceil().matrix().cast<int>() +
      Eigen::Vector3i::Ones();
  const Eigen::Vector3i low = box.low - room;
  Mask own(box.size() + 2 * room, liver.spacing_mm);
  each_shared(liver, own, low,
              [&](std::size_t from, std::size_t to) { own.voxels[to] = liver.voxels[from]; });
  Mask hull = closed(own, kHollow);
  add_bulges(hull, own);
  Mask result = liver;
  each_shared(liver, own, low,
              [&](std::size_t to, std::size_t from) { result.voxels[to] = hull.voxels[from]; });
  return result;
}

}  // namespace glisson::segmentation
