// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/patient/sound_cloud.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "glisson/core/error.h"

namespace glisson {
namespace {

constexpr double kAtTheLens = 5e-3;  ///< metres

/// Of these points the first of each place, look and feature, in the cloud's order.
std::vector<int> without_repeated(const LabelledCloud& cloud, std::vector<int> order) {
  const auto key = [&](int i) {
    return std::tuple(cloud.points(i, 0), cloud.points(i, 1), cloud.points(i, 2), cloud.look(i),
                      cloud.feature(i));
  };
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return key(a) < key(b); });
  order.erase(std::unique(order.begin(), order.end(), [&](int a, int b) { return key(a) == key(b); }),
              order.end());
  std::sort(order.begin(), order.end());
  return order;
}

/// Takes out what lies at the lens or behind it. @return how many.
int take_out_without_depth(const LabelledCloud& cloud, std::vector<int>& rows) {
  const auto z = [&](int i) { return cloud.points(i, 2); };
  const auto behind = std::count_if(rows.begin(), rows.end(), [&](int i) { return z(i) < 0.0; });
  if (2 * behind > static_cast<std::ptrdiff_t>(rows.size()))
    throw InputError("cloud", "z",
                     "lies behind the camera (" + std::to_string(behind) + " of " +
                         std::to_string(rows.size()) + " points)",
                     "Turn it by 180 degrees about x: here y runs down and z forward");
  return static_cast<int>(std::erase_if(rows, [&](int i) { return z(i) < kAtTheLens; }));
}

LabelledCloud chosen(const LabelledCloud& cloud, const std::vector<int>& rows) {
  LabelledCloud part;
  part.points = cloud.points(rows, Eigen::all);
  if (cloud.normals.rows() > 0) part.normals = cloud.normals(rows, Eigen::all);
  part.eyes = cloud.eyes;
  for (const int i : rows) {
    const auto at = static_cast<std::size_t>(i);
    if (!cloud.features.empty()) part.features.push_back(cloud.features[at]);
    if (!cloud.sigma.empty()) part.sigma.push_back(cloud.sigma[at]);
    if (!cloud.looks.empty()) part.looks.push_back(cloud.looks[at]);
  }
  return part;
}

}  // namespace

std::vector<std::string> CloudFaults::notes() const {
  std::vector<std::string> codes;
  if (repeated > 0) codes.push_back("cloud.repeated " + std::to_string(repeated));
  if (without_depth > 0) codes.push_back("cloud.without_depth " + std::to_string(without_depth));
  return codes;
}

LabelledCloud sound_cloud(const LabelledCloud& cloud, bool from_camera, CloudFaults& faults) {
  // What is not a number is refused where clouds are read, and by prepare_cloud(): it has no order here.
  if (!cloud.points.allFinite()) return cloud;
  std::vector<int> rows(static_cast<std::size_t>(cloud.size()));
  std::iota(rows.begin(), rows.end(), 0);
  const int without_depth = from_camera ? take_out_without_depth(cloud, rows) : 0;
  const std::size_t deep = rows.size();
  rows = without_repeated(cloud, std::move(rows));
  const int repeated = static_cast<int>(deep - rows.size());
  faults.without_depth += without_depth;
  faults.repeated += repeated;
  return repeated + without_depth > 0 ? chosen(cloud, rows) : cloud;
}

}  // namespace glisson
