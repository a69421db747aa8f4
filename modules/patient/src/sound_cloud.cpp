// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/patient/sound_cloud.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace glisson {
namespace {

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

/// Programs that make clouds without a camera turn normals outwards, inwards or not at all.
void turn_normals(LabelledCloud& cloud, CloudFaults& faults) {
  for (Eigen::Index i = 0; i < cloud.normals.rows(); ++i) {
    const Eigen::Vector3d from_eye = cloud.points.row(i).transpose() - cloud.eye(static_cast<int>(i));
    if (!(cloud.normals.row(i).dot(from_eye.transpose()) > 0.0)) continue;
    cloud.normals.row(i) *= -1.0;
    ++faults.turned;
  }
  faults.with_normals += static_cast<int>(cloud.normals.rows());
}

}  // namespace

std::vector<std::string> CloudFaults::notes() const {
  std::vector<std::string> codes;
  if (repeated > 0) codes.push_back("cloud.repeated " + std::to_string(repeated));
  if (without_depth > 0) codes.push_back("cloud.without_depth " + std::to_string(without_depth));
  if (10 * turned > with_normals) codes.push_back("cloud.normals_turned " + std::to_string(turned));
  if (behind > 0) codes.push_back("cloud.behind " + std::to_string(behind));
  return codes;
}

LabelledCloud sound_cloud(const LabelledCloud& cloud, bool from_camera, CloudFaults& faults) {
  // What is not a number is refused where clouds are read, and by prepare_cloud(): it has no order here.
  if (!cloud.points.allFinite()) return cloud;
  std::vector<int> rows(static_cast<std::size_t>(cloud.size()));
  std::iota(rows.begin(), rows.end(), 0);
  const auto all = rows.size();
  if (from_camera) std::erase_if(rows, [&](int i) { return cloud.points.row(i).isZero(0.0); });
  const auto deep = rows.size();
  rows = without_repeated(cloud, std::move(rows));
  faults.without_depth += static_cast<int>(all - deep);
  faults.repeated += static_cast<int>(deep - rows.size());
  if (from_camera)
    faults.behind += static_cast<int>(
        std::count_if(rows.begin(), rows.end(), [&](int i) { return cloud.points(i, 2) < 0.0; }));
  LabelledCloud sound = rows.size() < all ? rows_of(cloud, rows) : cloud;
  if (from_camera) turn_normals(sound, faults);
  return sound;
}

}  // namespace glisson
