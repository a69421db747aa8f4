// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "alarm.h"
#include "glisson/geometry/camera.h"
#include "glisson/geometry/mesh.h"
#include "glisson/patient/picture.h"
#include "glisson/patient/registration.h"
#include "stereo_follower.h"

namespace glisson::guidance {

/// Points that a mask of what is not liver silences (PictureMask). A mask belongs to an earlier picture, and
/// nothing tells how a tool has moved since. So the mask is not moved: each point is looked up where it was
/// in that picture. A point that is younger than the picture is looked up where it is now.
class HeldOut {
 public:
  /// @param window_px of Lucas-Kanade: a point whose window has a masked pixel follows that in part.
  /// @param most share of the organ in sight from which most of it is masked.
  HeldOut(const StereoRig& rig, int window_px, double most)
      : camera_(rig.left), margin_(window_px / 2), most_(most) {}

  /// What is asked from now on. Null, or of another size than the camera's: nothing is held out.
  /// @param now seconds of the source. @param surface of the organ, in the left camera's frame.
  void take(const std::shared_ptr<const PictureMask>& mask, double now, const TriangleMesh& surface);
  /// Of the mask that is asked; empty: there is none.
  const std::optional<MaskUse>& use() const { return use_; }
  /// Most of the organ is masked, with hysteresis.
  bool is_most() const { return most_masked_.stands(); }
  /// Whether the mask is why there are so few points.
  bool explains_few(int left, int wanted) const {
    return use_ && (use_->share >= most_ || (use_->held_out > 0 && left + use_->held_out >= wanted));
  }

  /// Where the points of a frame are; more may be told of the same frame. @param seconds of the source.
  void remember(int index, double seconds, const std::vector<FollowedPoint>& points);
  /// @return one decision a point, false: it is held out.
  std::vector<char> free(const std::vector<FollowedPoint>& points);
  /// Whether a point may begin at a left pixel.
  bool is_free(const Eigen::Vector2d& left) const;
  /// The mask that is asked, widened by half a window. Empty: there is none.
  const Picture& masked() const { return widened_; }
  /// Of the points that free() held out last, those that no mask has ever called liver: what is remembered of
  /// them is not the liver's.
  const std::vector<int>& never_liver() const { return never_liver_; }

 private:
  struct Places {
    int index = 0;
    double seconds = 0.0;
    std::map<int, Eigen::Vector2d> points;  ///< left pixels by the point's id
  };

  /// Of the surface's area before the camera and in the picture.
  double share_of(const TriangleMesh& surface) const;
  bool is_masked(const Picture& mask, const Eigen::Vector2d& left) const;

  Camera camera_;
  int margin_;
  double most_;
  std::shared_ptr<const PictureMask> mask_;
  Picture widened_;            ///< by the margin
  std::deque<Places> places_;  ///< by frame
  std::set<int> liver_;        ///< ids that a mask has let pass
  std::vector<int> never_liver_;
  std::optional<MaskUse> use_;
  Alarm most_masked_{2, 3};  ///< masks
};

}  // namespace glisson::guidance
