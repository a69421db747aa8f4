// SPDX-License-Identifier: GPL-3.0-or-later
#include "bites.h"

namespace glisson::segmentation {
namespace {

constexpr double kHollow = 50.0;  // mm: a tumour at the rim is a bite of up to this radius
constexpr double kDeep = 10.0;    // mm: of a bite out of which something may bulge
constexpr double kBulge = 20.0;   // mm beyond the mouth of such a bite

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
  Mask hull = closed(liver, kHollow);
  add_bulges(hull, liver);
  return hull;
}

}  // namespace glisson::segmentation
