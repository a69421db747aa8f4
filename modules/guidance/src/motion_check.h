// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <vector>

#include "stereo_follower.h"

namespace glisson::guidance {

/// What the followed points say of the pictures themselves: whether the scene moves at all (living tissue
/// always does: heart and breath), and whether both views show the same moment.
class MotionCheck {
 public:
  /// The points of two frames in turn; those that are in both are compared.
  void push(const std::vector<FollowedPoint>& before, const std::vector<FollowedPoint>& now,
            const StereoRig& rig);
  /// Forgets what it has seen, but not the calibration's own offset of rows.
  void clear() { frames_.clear(); }

  /// Squared motion of groups of neighbouring points over the last frames, as a multiple of what their noise
  /// alone makes (1: nothing moves), in either view; negative: too little is known yet.
  double motion_left() const { return motion(true); }
  double motion_right() const { return motion(false); }
  /// Median over the points of how far they are off their epipolar line, signed, less what it was at first:
  /// two views of one moment keep their rows. Pixels.
  double rows() const { return rows_; }
  /// By how much points differed in that at first, one deviation, pixels: what the calibration leaves changes
  /// over the picture, and a smaller change of the median may come from seeing another place.
  double rows_scatter() const { return rows_scatter_; }

 private:
  struct Frame {
    double left = 0.0, right = 0.0;
    bool known = false;
  };
  double motion(bool left) const;

  std::deque<Frame> frames_;
  double rows_ = 0.0, first_rows_ = 0.0, rows_scatter_ = 0.0;
  int rows_seen_ = 0;
};

/// Signed distance of the right pixel from the epipolar line of the left one, in pixels of the right camera.
double epipolar_offset(const StereoRig& rig, const Eigen::Vector2d& left, const Eigen::Vector2d& right);

}  // namespace glisson::guidance
