// SPDX-License-Identifier: GPL-3.0-or-later
#include "dark_bodies.h"

#include <algorithm>

#include "liver_start.h"
#include "painting.h"

namespace glisson::segmentation {
namespace {

constexpr double kBodyRadius = 4.0;  // mm: thinner are fissures, and voxels that mix at the rim
constexpr double kLeastMl = 4.0;     // a ball of 2 cm
constexpr std::size_t kMost = 3;

}  // namespace

std::vector<DarkBody> dark_bodies(const Field& ct, const Bodies& bodies,
                                  const std::vector<Eigen::Vector3i>& clicks) {
  const auto darkest =
      static_cast<float>(bodies.parenchyma.mean - kLiverWidth * std::max(bodies.parenchyma.sigma, kDrift));
  Mask dark = bodies.liver;
  Mask lesions = ct.empty_mask();
  for (const GrownLesion& lesion : bodies.lesions)
    if (is_found(lesion)) unite(lesions, transferred(lesion.phi, ct));
  for (std::size_t i = 0; i < dark.voxels.size(); ++i)
    if (ct.values[i] <= kEmptyTissue || ct.values[i] >= darkest) dark.voxels[i] = 0;
  dark = opened(dark, kBodyRadius);
  std::vector<long> sizes;
  const std::vector<int> body = connected_components(dark, sizes);
  std::vector<char> is_known(sizes.size() + 1, 0);
  is_known[0] = 1;
  for (std::size_t i = 0; i < body.size(); ++i)
    if (lesions.voxels[i] != 0) is_known[static_cast<std::size_t>(body[i])] = 1;
  for (const Eigen::Vector3i& click : clicks)
    if (ct.contains(click)) is_known[static_cast<std::size_t>(body[ct.offset(click)])] = 1;

  const double voxel_ml = 1e-3 * ct.spacing_mm.prod();
  std::vector<DarkBody> found(sizes.size());
  std::vector<Eigen::Vector3d> middle(sizes.size(), Eigen::Vector3d::Zero());
  for (std::size_t i = 0; i < body.size(); ++i)
    if (body[i] > 0) middle[static_cast<std::size_t>(body[i] - 1)] += ct.voxel_at(i).cast<double>();
  std::vector<double> nearest(sizes.size(), std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < body.size(); ++i) {
    if (body[i] <= 0) continue;
    const auto n = static_cast<std::size_t>(body[i] - 1);
    const Eigen::Vector3d here = ct.voxel_at(i).cast<double>();
    const double apart =
        (here - middle[n] / static_cast<double>(sizes[n])).cwiseProduct(ct.spacing_mm).squaredNorm();
    if (apart >= nearest[n]) continue;
    nearest[n] = apart;
    found[n] = {voxel_ml * static_cast<double>(sizes[n]), ct.first_index + here.cwiseProduct(ct.step)};
  }
  std::vector<DarkBody> told;
  for (std::size_t n = 0; n < found.size(); ++n)
    if (is_known[n + 1] == 0 && found[n].ml >= kLeastMl) told.push_back(found[n]);
  std::stable_sort(told.begin(), told.end(),
                   [](const DarkBody& a, const DarkBody& b) { return a.ml > b.ml; });
  if (told.size() > kMost) told.resize(kMost);
  return told;
}

}  // namespace glisson::segmentation
