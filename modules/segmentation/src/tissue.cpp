// SPDX-License-Identifier: GPL-3.0-or-later
#include "tissue.h"

#include <algorithm>
#include <cmath>

#include "glisson/core/error.h"
#include "glisson/core/statistics.h"

namespace glisson::segmentation {
namespace {

constexpr double kSeedRadius = 6.0;  // mm, where a click's statistics are taken

Tissue robust_tissue(std::vector<float>& values, double low_sigma, double high_sigma) {
  Tissue tissue;
  const Spread<float> spread = robust_spread(std::move(values));
  tissue.mean = spread.middle;
  tissue.sigma = std::clamp(spread.deviation, low_sigma, high_sigma);
  return tissue;
}

}  // namespace

void require_ct(const Image& image) {
  if (image.empty()) throw InputError("image", "", "is empty", "Import a CT first");
  if (image.modality != Modality::ct)
    throw InputError("image", "modality",
                     "is not CT, and only a CT says what grey a liver has before it is clicked",
                     "Click the liver yourself");
}

Tissue tissue_around(const Field& ct, const std::vector<Eigen::Vector3i>& points, double radius_mm,
                     double low_sigma, double high_sigma) {
  std::vector<float> values;
  const Eigen::Vector3i reach =
      (radius_mm * ct.spacing_mm.cwiseInverse()).array().ceil().matrix().cast<int>();
  for (const Eigen::Vector3i& p : points)
    for (int k = -reach.z(); k <= reach.z(); ++k)
      for (int j = -reach.y(); j <= reach.y(); ++j)
        for (int i = -reach.x(); i <= reach.x(); ++i) {
          const Eigen::Vector3i v = p + Eigen::Vector3i(i, j, k);
          if (ct.contains(v) && Eigen::Vector3d(i, j, k).cwiseProduct(ct.spacing_mm).norm() <= radius_mm)
            values.push_back(ct.values[ct.offset(v)]);
        }
  require(!values.empty(), "a tissue is estimated around points inside the volume");
  return robust_tissue(values, low_sigma, high_sigma);
}

Tissue tissue_in(const Field& ct, const Mask& mask) {
  std::vector<float> values;
  for (std::size_t i = 0; i < mask.voxels.size(); ++i)
    if (mask.voxels[i] != 0) values.push_back(ct.values[i]);
  require(!values.empty(), "a tissue is estimated in a mask that holds something");
  return robust_tissue(values, kLeastLiverSigma, kMostLiverSigma);
}

Tissue liver_at(const Field& ct, const std::vector<Eigen::Vector3i>& clicks) {
  std::vector<float> means, sigmas;
  for (const Eigen::Vector3i& click : clicks) {
    const Tissue one = tissue_around(ct, {click}, kSeedRadius, 0.0, kMostLiverSigma);
    means.push_back(static_cast<float>(one.mean));
    sigmas.push_back(static_cast<float>(one.sigma));
  }
  const auto [middle, between] = robust_spread(std::move(means));
  return {middle, std::clamp(std::hypot(std::max(between, kDrift), upper_median(sigmas)), kLeastLiverSigma,
                             kMostLiverSigma)};
}

Tissue tissue_within(const Field& ct, const Mask& region, double depth_mm) {
  const Mask deep = eroded(holes_filled(closed(region, kVesselWidth)), depth_mm);
  std::vector<float> values;
  for (std::size_t i = 0; i < deep.voxels.size(); ++i)
    if (deep.voxels[i] != 0) values.push_back(ct.values[i]);
  return values.empty() ? Tissue{0.0, 0.0} : robust_tissue(values, kLeastLiverSigma, kMostLiverSigma);
}

}  // namespace glisson::segmentation
