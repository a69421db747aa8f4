// SPDX-License-Identifier: GPL-3.0-or-later
#include "organs.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace glisson::segmentation {
namespace {

/// Voxels whose intensity lies in (low, high).
Mask between(const Field& ct, double low, double high) {
  Mask mask = ct.empty_mask();
  for (std::size_t i = 0; i < mask.voxels.size(); ++i)
    mask.voxels[i] = ct.values[i] > low && ct.values[i] < high ? 1 : 0;
  return mask;
}

/// The part of `mask` in the box around a voxel, `radius_mm` to each side.
VoxelBox box_around(const Field& ct, const Eigen::Vector3i& centre, double radius_mm) {
  VoxelBox box;
  for (int axis = 0; axis < 3; ++axis) {
    const int reach = static_cast<int>(std::ceil(radius_mm / ct.spacing_mm[axis]));
    box.low[axis] = std::max(0, centre[axis] - reach);
    box.high[axis] = std::min(ct.size[axis], centre[axis] + reach + 1);
  }
  return box;
}

/// Climbs from `v` to where the depth is locally greatest.
Eigen::Vector3i deepest_near(const Mask& part, const std::vector<float>& depth2, Eigen::Vector3i v) {
  while (true) {
    Eigen::Vector3i best = v;
    for (int k = -2; k <= 2; ++k)
      for (int j = -2; j <= 2; ++j)
        for (int i = -2; i <= 2; ++i) {
          const Eigen::Vector3i w = v + Eigen::Vector3i(i, j, k);
          if ((w.array() < 0).any() || (w.array() >= part.size.array()).any()) continue;
          if (depth2[part.offset(w.x(), w.y(), w.z())] > depth2[part.offset(best.x(), best.y(), best.z())])
            best = w;
        }
    if (best == v) return v;
    v = best;
  }
}

/// Components of `mask` that hold one of the marked voxels.
Mask touching(const Mask& mask, const std::vector<std::size_t>& marks) {
  std::vector<long> sizes;
  const std::vector<int> number = connected_components(mask, sizes);
  std::vector<std::uint8_t> keep(sizes.size() + 1, 0);
  for (const std::size_t at : marks) keep[static_cast<std::size_t>(number[at])] = 1;
  keep[0] = 0;
  Mask result(mask.size, mask.spacing_mm);
  for (std::size_t i = 0; i < number.size(); ++i)
    result.voxels[i] = keep[static_cast<std::size_t>(number[i])];
  return result;
}

/// One seed's body within a box.
void grow_one(const Field& ct, const Mask& alike, const Eigen::Vector3i& seed, Mask& body) {
  constexpr double kLargest = 80.0;  // mm: half the width of the box that is searched
  const VoxelBox box = box_around(ct, seed, kLargest);
  const Mask part = crop(ct.size, ct.spacing_mm, alike.voxels, box);
  const std::vector<float> depth2 = squared_distance_mm2(complement(part));
  const Eigen::Vector3i centre = deepest_near(part, depth2, seed - box.low);
  const double half_width = std::sqrt(depth2[part.offset(centre.x(), centre.y(), centre.z())]);
  if (!(half_width > 0.0)) return;
  const double neck = 0.5 * half_width;
  Mask core(part.size, part.spacing_mm);
  for (std::size_t i = 0; i < core.voxels.size(); ++i) core.voxels[i] = std::sqrt(depth2[i]) > neck;
  core = touching(core, {core.offset(centre.x(), centre.y(), centre.z())});
  const Mask grown = dilated(core, neck);
  for (int k = 0; k < part.size.z(); ++k)
    for (int j = 0; j < part.size.y(); ++j)
      for (int i = 0; i < part.size.x(); ++i) {
        const std::size_t at = part.offset(i, j, k);
        const double d =
            (Eigen::Vector3i(i, j, k) - centre).cast<double>().cwiseProduct(ct.spacing_mm).norm();
        if (grown.voxels[at] != 0 && part.voxels[at] != 0 && d < 4.0 * half_width)
          body.voxels[ct.offset(box.low + Eigen::Vector3i(i, j, k))] = 1;
      }
}

/// Slice `n` along `axis` of a 3-D mask, as a flat one, and back.
Mask slice_of(const Mask& mask, int axis, int n) {
  VoxelBox box{Eigen::Vector3i::Zero(), mask.size};
  box.low[axis] = n;
  box.high[axis] = n + 1;
  return crop(mask.size, mask.spacing_mm, mask.voxels, box);
}
void put_slice(const Mask& slice, int axis, int n, Mask& mask) {
  VoxelBox box{Eigen::Vector3i::Zero(), mask.size};
  box.low[axis] = n;
  box.high[axis] = n + 1;
  paste(slice, box, mask.size, mask.voxels);
}

Mask both(Mask a, const Mask& b) {
  for (std::size_t i = 0; i < a.voxels.size(); ++i) a.voxels[i] = a.voxels[i] != 0 && b.voxels[i] != 0;
  return a;
}

constexpr double kCavaStep = 2.5;  // mm that the cava's wall moves from slice to slice at most
constexpr double kCavaNeck = 3.0;  // mm, closes the mouths of smaller veins
constexpr double kCavaRim = 5.0;   // mm outside what looks alike in which the blood's edge is looked for
constexpr double kAlike = 2.5;     // sigmas of the blood

/// Intensity at a place of the grid, bilinear in the slice across `axis`, constant beyond the edge.
double value_in_slice(const Field& ct, int axis, const Eigen::Vector3d& at) {
  const int a = (axis + 1) % 3, b = (axis + 2) % 3;
  const Eigen::Vector3i most = ct.size - Eigen::Vector3i::Ones();
  const Eigen::Vector3d p = at.cwiseMax(0.0).cwiseMin(most.cast<double>());
  const Eigen::Vector3i low = p.array().floor().matrix().cast<int>();
  double value = 0.0;
  for (int n = 0; n < 4; ++n) {
    Eigen::Vector3i v = low;
    v[a] = std::min(v[a] + n % 2, most[a]);
    v[b] = std::min(v[b] + n / 2, most[b]);
    const double wa = p[a] - low[a], wb = p[b] - low[b];
    value += (n % 2 != 0 ? wa : 1.0 - wa) * (n / 2 != 0 ? wb : 1.0 - wb) * ct.values[ct.offset(v)];
  }
  return value;
}

/// How far the blood reaches from voxel `from` towards `to` in its slice, mm: to where the intensity is half
/// way down its first fall. Only the first counts, since behind a thin wall of liver there may be fat. 0:
/// there is no edge, for it falls by less than `least` (the mouth of a vein).
double blood_edge(const Field& ct, int axis, const Eigen::Vector3i& from, const Eigen::Vector3i& to,
                  double blood, double least) {
  constexpr int kSamples = 15;     // half a millimetre apart: 2 mm more than the rim
  constexpr int kWindow = 4;       // samples over which a fall is measured
  constexpr double kEnded = 0.25;  // of the steepest fall
  const Eigen::Vector3d way = (to - from).cast<double>();
  const Eigen::Vector3d step = 0.5 / way.cwiseProduct(ct.spacing_mm).norm() * way;
  std::array<double, kSamples> value{};
  for (int n = 0; n < kSamples; ++n) value[n] = value_in_slice(ct, axis, from.cast<double>() + n * step);
  double beside = value.back(), steepest = 0.0;
  for (int n = 0; n + kWindow < kSamples; ++n) {
    const double fall = value[n] - value[n + kWindow];
    steepest = std::max(steepest, fall);
    if (blood - value[n] < least || fall >= kEnded * steepest) continue;
    beside = value[n];
    break;
  }
  if (blood - beside < least) return 0.0;
  const double half = 0.5 * (blood + beside);
  int n = 0;
  while (n < kSamples && value[n] > half) ++n;
  return 0.5 * n;
}

/// The cross-section in slice `n` out to the blood's edge. What looks alike ends 2 to 4 mm inside it, where
/// the CT's blur begins; without this step the rim that is left would look like a vein of the liver.
Mask with_rim(const Field& ct, const Mask& section, int axis, int n, double least) {
  const int a = (axis + 1) % 3, b = (axis + 2) % 3;
  const auto places_of = [&](const Mask& mask) {
    std::vector<Eigen::Vector3i> places;
    Eigen::Vector3i v = Eigen::Vector3i::Zero();
    for (v[b] = 0; v[b] < ct.size[b]; ++v[b])
      for (v[a] = 0; v[a] < ct.size[a]; ++v[a])
        if (mask.voxels[mask.offset(v.x(), v.y(), v.z())] != 0)
          places.push_back(v + n * Eigen::Vector3i::Unit(axis));
    return places;
  };
  const std::vector<Eigen::Vector3i> inside = places_of(section);
  if (inside.empty()) return section;
  double blood = 0.0;
  for (const Eigen::Vector3i& v : inside)
    blood += ct.values[ct.offset(v)] / static_cast<double>(inside.size());
  Mask whole = section;
  for (const Eigen::Vector3i& v : places_of(dilated(section, kCavaRim))) {
    const auto far = [&](const Eigen::Vector3i& p) {
      return (v - p).cast<double>().cwiseProduct(ct.spacing_mm).norm();
    };
    const Eigen::Vector3i from = *std::min_element(
        inside.begin(), inside.end(), [&](const auto& x, const auto& y) { return far(x) < far(y); });
    if (from == v || far(from) >= blood_edge(ct, axis, from, v, blood, least)) continue;
    Eigen::Vector3i flat = v;
    flat[axis] = 0;
    whole.voxels[whole.offset(flat.x(), flat.y(), flat.z())] = 1;
  }
  return opened(whole, kCavaNeck);
}

}  // namespace

Mask grow_body(const Field& ct, const std::vector<Eigen::Vector3i>& seeds, const Tissue& liver) {
  Mask body = ct.empty_mask();
  for (const Eigen::Vector3i& seed : seeds) {
    const Tissue own = tissue_around(ct, {seed}, 4.0, 5.0, 15.0);
    const double middle = 0.5 * (own.mean + liver.mean);
    const bool darker = own.mean < liver.mean;
    const double low = darker ? own.mean - 3.0 * own.sigma : std::max(middle, own.mean - 3.0 * own.sigma);
    const double high = darker ? std::min(middle, own.mean + 3.0 * own.sigma) : own.mean + 3.0 * own.sigma;
    grow_one(ct, between(ct, low, high), seed, body);
  }
  return body.count() > 0 ? holes_filled(body) : body;
}

Mask follow_cava(const Field& ct, const std::vector<Eigen::Vector3i>& seeds, int axis) {
  const Tissue own = tissue_around(ct, seeds, 4.0, 4.0, 12.0);
  const double least = kAlike * own.sigma;
  const Mask alike = between(ct, own.mean - least, own.mean + least);
  Mask cava = ct.empty_mask();
  for (const Eigen::Vector3i& seed : seeds) {
    // The first cross-section: what is alike around the click, no wider than a cava.
    Mask near = ct.empty_mask();
    near.voxels[ct.offset(seed)] = 1;
    Mask first = both(slice_of(alike, axis, seed[axis]), dilated(slice_of(near, axis, seed[axis]), 16.0));
    std::size_t mark = 0;
    {
      Mask seed_slice = slice_of(near, axis, seed[axis]);
      mark = static_cast<std::size_t>(std::find(seed_slice.voxels.begin(), seed_slice.voxels.end(), 1) -
                                      seed_slice.voxels.begin());
    }
    first = touching(opened(first, kCavaNeck), {mark});
    const long area = first.count();
    if (area == 0) continue;
    put_slice(first, axis, seed[axis], cava);
    for (const int direction : {-1, 1}) {
      Mask last = first;
      for (int n = seed[axis] + direction; n >= 0 && n < ct.size[axis]; n += direction) {
        Mask next = both(slice_of(alike, axis, n), dilated(last, kCavaStep));
        next = largest_component(opened(next, kCavaNeck));
        const long count = next.count();
        if (count < area / 5 || count > 2 * area) break;
        put_slice(next, axis, n, cava);
        last = next;
      }
    }
  }
  if (cava.count() == 0) return cava;
  for (int n = 0; n < ct.size[axis]; ++n)
    put_slice(with_rim(ct, slice_of(cava, axis, n), axis, n, least), axis, n, cava);
  return closed(cava, 3.0);
}

}  // namespace glisson::segmentation
