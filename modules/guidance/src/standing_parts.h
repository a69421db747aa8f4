// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "frame_clock.h"
#include "glisson/patient/picture.h"
#include "stereo_follower.h"

namespace glisson::guidance {

/// Finds a part of a view that stands while the tissue beside it moves: half of a picture that is no longer
/// written, say. A view has 8 x 6 parts. One stands when it is the same to the last grey level for 0.3 s, and
/// the points on the organ that are followed there stand as well; that is told once points at most two parts
/// away have moved by a millimetre since. Tissue is elastic and does not tear, and a sensor's noise is
/// another in every picture. A codec repeats what hardly changes, but not tissue beside such a motion; what
/// has no points of the organ (black bars, writing in the picture, what lies behind) does not count. Where
/// scope and organ stand, nothing is told.
class StandingParts {
 public:
  explicit StandingParts(const StereoRig& rig) : rig_(rig) {}

  /// The next frame. @param points that were followed into it. @param clock of the frames.
  void push(const StereoFrame& frame, const std::vector<FollowedPoint>& points, const FrameClock& clock);
  /// Whether there is such a part, in either view.
  bool any() const { return any_; }

 private:
  static constexpr int kColumns = 8, kRows = 6;
  static constexpr std::size_t kParts = std::size_t{kColumns} * kRows;
  /// Metres across the line of sight by which each part's points have moved since the first frame.
  using Ways = Eigen::Matrix<double, 2, int{kParts}>;

  struct Part {
    int frames = 0;            ///< in a row that were the same
    double since = 0.0;        ///< seconds of the clock: the first of them
    Ways then = Ways::Zero();  ///< at that time
    bool is_told = false;
  };
  struct View {
    std::vector<std::uint8_t> grey;         ///< at the places of a grid
    std::map<int, Eigen::Vector2d> points;  ///< pixels
    Ways ways = Ways::Zero();
    std::array<int, kParts> followed{};  ///< points in the part that were in the frame before, too
    std::array<Part, kParts> parts;
  };
  static std::size_t part_at(double x, double y, int width, int height);
  static std::array<bool, kParts> same_parts(const Picture& picture, View& view);
  void move_points(const std::vector<FollowedPoint>& points, bool is_left, View& view) const;
  static bool moves_beside(const View& view, std::size_t part);
  static bool look(const std::array<bool, kParts>& same, const FrameClock& clock, View& view);

  StereoRig rig_;
  View left_, right_;
  bool any_ = false;
};

}  // namespace glisson::guidance
