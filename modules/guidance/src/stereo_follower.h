// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "glisson/geometry/camera.h"
#include "glisson/patient/picture.h"
#include "seen_parts.h"

namespace cv {
class Mat;
}

namespace glisson::guidance {

/// A point that both cameras follow.
struct FollowedPoint {
  int id = 0;  ///< of a place of the tissue: one that comes back has its own again
  Eigen::Vector2d left = Eigen::Vector2d::Zero(), right = Eigen::Vector2d::Zero();  ///< pixels
  Eigen::Vector3d p_in_camera = Eigen::Vector3d::Zero();                            ///< metres
  Eigen::Matrix3d information = Eigen::Matrix3d::Identity();                        ///< see Triangulated
};

struct FollowerOptions {
  int points = 200;
  double forward_backward_px = 1.0;
  double epipolar_px = 2.0;
  int window_px = 17, levels = 3;
};

/// Shi and Tomasi's corners on the organ, followed by pyramidal Lucas-Kanade forward and backward in both
/// pictures. A pair is matched once, when it is made: the expected depth says where to look in the right
/// picture. Each frame's pyramid is built once and serves as "next" and then as "previous".
class StereoFollower {
 public:
  /// Where the organ is expected along a left pixel's ray, in the camera's frame; empty: no organ there.
  using Expected = std::function<std::optional<Eigen::Vector3d>(const Eigen::Vector2d& left)>;

  StereoFollower(const StereoRig& rig, const FollowerOptions& options);
  ~StereoFollower();

  /// @param parts points start where `tissue` is, and go where they leave `left` or `right`.
  /// @throws InputError when a picture is not of the calibration's size.
  void begin(const StereoFrame& first, const SeenParts& parts);

  /// Follows all points into the next frame; those that fail a gate are gone.
  /// @return how many each camera followed on its own, before the gates between the two.
  struct Counts {
    int left = 0, right = 0;
  };
  /// @throws InputError when a picture is not of the calibration's size. Whatever is thrown, the last frame
  /// and its points are what is followed from next.
  Counts follow(const StereoFrame& frame);

  /// Keeps the points whose entry is true. @pre one entry a point.
  void keep(const std::vector<char>& kept);
  /// Takes the last accepted frame and points as the place to follow from again (the present frame was no
  /// good); undoes the last follow().
  void forget_last();
  /// Other points of the last frame, where they are in the present one: through the same gates. Empty: they
  /// failed one. @pre follow() or begin() was called, and not undone.
  std::vector<std::optional<FollowedPoint>> carried(const std::vector<FollowedPoint>& points) const;
  /// Finds new points in the present frame, away from those that there are, up to the number wanted.
  /// @return how many were added, at the end of points().
  int replenish(const Expected& expected);
  /// New points that are none of points(), at most `wanted`, away from those of `others`; their ids are 0.
  /// @param where half the left view's size, non-zero where they may be; empty: everywhere.
  std::vector<FollowedPoint> find(const Expected& expected, int wanted,
                                  const std::vector<FollowedPoint>& others, const cv::Mat& where) const;
  /// Pixels that new points keep from others.
  double spacing() const;

  /// Puts a point elsewhere. @return false: the two rays do not meet, and it stays.
  bool put(std::size_t index, const Eigen::Vector2d& left, const Eigen::Vector2d& right);
  /// Adds a known point. @return false: outside of what is seen, or the rays do not meet.
  bool add(int id, const Eigen::Vector2d& left, const Eigen::Vector2d& right);
  /// The present frame's view.
  const cv::Mat& grey(bool left) const;

  const std::vector<FollowedPoint>& points() const { return points_; }

 private:
  struct Images;
  /// As follow(), from the pictures that were made the ones before.
  Counts follow_from_before(const StereoFrame& frame);
  bool is_seen_by_both(const FollowedPoint& point) const;
  /// `points` with the pixels that were found, where they pass the gates between the two cameras.
  std::optional<FollowedPoint> passed(const FollowedPoint& point, const Eigen::Vector2d& left,
                                      const Eigen::Vector2d& right) const;
  /// @return false: the rays do not meet.
  bool triangulate_into(FollowedPoint& point) const;

  StereoRig rig_;
  FollowerOptions options_;
  std::vector<FollowedPoint> points_, before_;
  std::unique_ptr<Images> images_;
  int next_id_ = 0;
};

}  // namespace glisson::guidance
