// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filmed_phantom.h"
#include "stereo_follower.h"

namespace glisson::phantom {

/// The body that the judge's tests look at, how it is filmed, and what may hide it.
class JudgedFilm {
 protected:
  /// Where the body is at first, and the frame of it.
  void make_film() {
    nodes_ = view().apply(model_.mesh.vertices);
    first_ = film(model_, nodes_, rig_, 0);
  }
  static guidance::TrackerOptions options() { return free_body(); }
  Points moved(const Eigen::Vector3d& by) const { return nodes_.rowwise() + by.transpose(); }
  /// A film of the body moving down by half a millimetre a frame.
  StereoFrame frame(int k) const { return film(model_, moved({0.0, 0.5e-3 * k, -0.2e-3 * k}), rig_, k); }
  /// Something flat and textured before the organ. @param half pixels of its width. @param depth metres
  /// before the lens.
  StereoFrame behind_a_tool(const StereoFrame& frame, double half = 22.0, double depth = 60e-3) const {
    StereoFrame covered = frame;
    for (Picture* picture : {&covered.left, &covered.right}) {
      auto bytes = std::make_shared<std::vector<std::uint8_t>>(*picture->bytes);
      // The cameras turn towards each other by 0.02, so what is far is shifted, too.
      const double shift = picture == &covered.left ? 0.0 : 260.0 * (5e-3 / depth - 0.02);
      for (int y = 0; y < picture->height; ++y)
        for (int x = 0; x < picture->width; ++x)
          if (const double u = x + shift, across = u - 190.0 + 0.3 * (y - 120.0); std::abs(across) < half)
            (*bytes)[static_cast<std::size_t>(y * picture->width + x)] =
                static_cast<std::uint8_t>(60.0 + 150.0 * value_noise(Eigen::Vector3d(u / 7.0, y / 7.0, 0.5)));
      picture->bytes = bytes;
    }
    return covered;
  }
  static std::vector<guidance::FollowedPoint> grid(const StereoRig& rig) {
    std::vector<guidance::FollowedPoint> points;
    for (int i = 0; i < 200; ++i) {
      guidance::FollowedPoint point;
      point.id = i;
      point.p_in_camera = {0.004 * (i % 20 - 10), 0.006 * (i / 20 - 5), 0.12};
      point.left = rig.left.project(point.p_in_camera);
      point.right = rig.right.project(rig.right_from_left.rotation * point.p_in_camera +
                                      rig.right_from_left.translation);
      points.push_back(point);
    }
    return points;
  }

  StereoRig rig_ = rig();
  PatientModel model_ = model(8, 6, 3);
  Points nodes_;
  StereoFrame first_;
};

}  // namespace glisson::phantom
