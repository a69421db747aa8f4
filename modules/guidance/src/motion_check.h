// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <deque>
#include <map>
#include <vector>

#include "frame_clock.h"
#include "stereo_follower.h"

namespace glisson::guidance {

/// What the followed points say of the pictures themselves: whether the scene moves at all (living tissue
/// always does: heart and breath), and whether both views show the same moment and stand to each other as
/// calibrated.
class MotionCheck {
 public:
  /// The points of the next frame. @param seconds its time.
  void push(const std::vector<FollowedPoint>& points, const StereoRig& rig, double seconds);

  /// How much groups of neighbouring points move together over the last 0.4 s, squared, as a multiple of what
  /// their noise alone makes (1: nothing moves), in either view: the F ratio of an analysis of variance by
  /// points and frames. Negative: too little is known yet.
  double motion_left() const { return motion_[0]; }
  double motion_right() const { return motion_[1]; }
  /// Enough time has been seen. If motion is unknown all the same, too few points lie together.
  bool is_whole() const;
  /// Median over the points of how far they are off their epipolar line, signed, less what it was at first:
  /// two views of one moment keep their rows. Pixels. A fault that is there from the first is no norm: not
  /// more than a calibration may leave is taken off.
  double rows() const { return rows_; }
  /// By how much points differed in that at first, one deviation, pixels: what the calibration leaves changes
  /// over the picture, and a smaller change of the median may come from seeing another place.
  double rows_scatter() const { return rows_scatter_; }
  /// From how many pixels of rows() on the views show different moments. @param least in pictures up to 960
  /// pixels wide; more in larger ones (pixel_scale()), and where the points scattered by more at first.
  double rows_limit(double least) const { return std::max(scale_ * least, rows_scatter_); }
  /// By how much all depths have become wrong since the first points, metres, negative: too small. Tissue
  /// bends and is pulled here and there, but what is in sight does not grow or shrink as a whole. Where most
  /// distances between its places did, by the same share, one view has been shifted along the rows, which
  /// makes every disparity wrong. 0 while a quarter of the distances say otherwise, or too few places are
  /// known.
  double depth_off() const { return depth_off_; }

 private:
  /// A point's pixels: left x and y, right x and y.
  using Pixels = std::map<int, Eigen::Vector4d>;

  struct Frame {
    double seconds = 0.0;
    Pixels pixels;
  };

  void keep(Frame now);
  void look_at_motion(const StereoRig& rig);
  void look_at_size(const std::vector<FollowedPoint>& points);

  std::deque<Frame> frames_;  ///< by the clock
  FrameClock clock_;
  std::array<double, 2> motion_{-1.0, -1.0};  ///< left, right
  double rows_ = 0.0, first_rows_ = 0.0, rows_scatter_ = 0.0;
  int rows_seen_ = 0;
  double scale_ = 1.0;  ///< of limits in pixels
  /// Of points, camera's frame, metres: distances are held against theirs.
  std::map<int, Eigen::Vector3d> first_places_;
  double grown_before_ = 0.0, growth_ = 0.0;  ///< logarithms: until first_places_, and until now
  double depth_off_ = 0.0;
};

/// Signed distance of the right pixel from the epipolar line of the left one, in pixels of the right camera.
double epipolar_offset(const StereoRig& rig, const Eigen::Vector2d& left, const Eigen::Vector2d& right);

}  // namespace glisson::guidance
