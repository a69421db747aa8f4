// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/stereo/evaluate.h"

#include <algorithm>
#include <cmath>

#include "glisson/core/error.h"
#include "glisson/core/statistics.h"
#include "glisson/geometry/closest_point_tree.h"

namespace glisson::stereo {
namespace {

/// @param signed_errors NaN: no truth.
CloudErrors summary(const LabelledCloud& cloud, const std::vector<double>& signed_errors) {
  CloudErrors errors;
  std::vector<double> known, unsigned_errors, ratios;
  for (std::size_t i = 0; i < signed_errors.size(); ++i) {
    const double error = signed_errors[i];
    if (std::isnan(error)) {
      ++errors.without_truth;
      continue;
    }
    known.push_back(error);
    unsigned_errors.push_back(std::abs(error));
    if (!cloud.sigma.empty() && cloud.sigma[i] > 0.0)
      ratios.push_back(error * error / (cloud.sigma[i] * cloud.sigma[i]));
  }
  errors.distance = summarise(unsigned_errors);
  errors.bias = known.empty() ? 0.0 : upper_median(known);
  for (double& error : known) error = std::abs(error - errors.bias);
  errors.unbiased = summarise(known);
  errors.errors = signed_errors;
  errors.normalised = ratios.empty() ? 0.0 : upper_median(ratios) / kMedianOfChiSquare;
  return errors;
}

}  // namespace

CloudErrors cloud_errors(const LabelledCloud& cloud, const TriangleMesh& surface_in_camera) {
  require(surface_in_camera.triangle_count() > 0, "a surface to compare with has triangles");
  const ClosestPointTree tree(surface_in_camera);
  std::vector<double> errors;
  for (Eigen::Index i = 0; i < cloud.points.rows(); ++i) {
    const Eigen::Vector3d p = cloud.points.row(i).transpose();
    const ClosestPoint closest = tree.closest(p);
    errors.push_back(std::copysign(closest.distance, (p - closest.point).dot(p)));
  }
  return summary(cloud, errors);
}

CloudErrors cloud_errors(const LabelledCloud& cloud, const Camera& left, const std::vector<float>& depth) {
  require(depth.size() == static_cast<std::size_t>(left.width) * static_cast<std::size_t>(left.height),
          "a depth map has an entry for each pixel of its camera");
  std::vector<double> errors;
  for (Eigen::Index i = 0; i < cloud.points.rows(); ++i) {
    errors.push_back(std::nan(""));
    const Eigen::Vector3d p = cloud.points.row(i).transpose();
    if (p.z() <= 0.0) continue;
    const Eigen::Vector2d pixel = left.project(p);
    const double x0 = std::floor(pixel.x()), y0 = std::floor(pixel.y());
    if (!(x0 >= 0.0 && y0 >= 0.0 && x0 < left.width - 1 && y0 < left.height - 1)) continue;
    const double fx = pixel.x() - x0, fy = pixel.y() - y0;
    const double weights[] = {(1 - fx) * (1 - fy), fx * (1 - fy), (1 - fx) * fy, fx * fy};
    double inverse = 0.0;  // linear in the picture where the surface is flat
    for (int k = 0; k < 4; ++k) {
      const auto at = (static_cast<std::size_t>(y0) + static_cast<std::size_t>(k / 2)) *
                          static_cast<std::size_t>(left.width) +
                      static_cast<std::size_t>(x0) + static_cast<std::size_t>(k % 2);
      inverse += depth[at] > 0.0F ? weights[k] / static_cast<double>(depth[at]) : std::nan("");
    }
    errors.back() = (p.z() - 1.0 / inverse) * p.norm() / p.z();
  }
  return summary(cloud, errors);
}

}  // namespace glisson::stereo
