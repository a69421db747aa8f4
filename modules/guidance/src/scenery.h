// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "frame_clock.h"
#include "glisson/geometry/mesh.h"
#include "glisson/geometry/rigid.h"
#include "stereo_follower.h"

namespace glisson::guidance {

/// What stands beside the organ in both pictures, followed, and what it tells of the scope's motion. The
/// organ's own points cannot tell whether scope or organ moved; where the two differ, the wall behind the
/// organ does. Its points are places of one rigid scene, and the scope's place before it is the one that most
/// of them agree on: tools, bowels that move by themselves and wrong matches are outvoted. Not thread-safe.
class Scenery {
 public:
  explicit Scenery(const StereoRig& rig) : rig_(rig) {}

  /// Nothing is known: where the scope is now is where it begins. New places are looked for when it is time.
  void begin();
  /// Follows what is known into the follower's present frame. @param guess how the scene may have moved in
  /// the left camera's frame since the last one (as the organ): where the search begins. @param organ its
  /// middle, metres, in the present frame: there the motion must be known to 1 mm.
  /// @return the scene's motion in the camera's frame since the last frame; empty: too few points, most of
  ///   them disagree, or they tell too little of it. Then begin().
  std::optional<RigidMotion> follow(const StereoFollower& follower, const RigidMotion& guess,
                                    const Eigen::Vector3d& organ);
  /// The camera's frame of the last frame from that where it began.
  const RigidMotion& camera_from_scene() const { return camera_from_scene_; }
  /// Looks for new places beside the organ, when many are missing: seldom where there are none.
  /// @param organ its surface in the left camera's frame. @param masked what is neither organ nor wall (left
  ///   picture), or empty.
  void replenish(const StereoFollower& follower, const TriangleMesh& organ, const Picture& masked,
                 const FrameClock& clock);

  const std::vector<FollowedPoint>& points() const { return points_; }
  int count() const { return static_cast<int>(points_.size()); }

 private:
  /// A place of the scene, by the information of all its looks: the scene's frame is the left camera's where
  /// it began, metres.
  struct Place {
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    Eigen::Vector3d weighted = Eigen::Vector3d::Zero();
    Eigen::Vector3d at = Eigen::Vector3d::Zero();
  };
  void look(std::size_t index);

  StereoRig rig_;
  std::vector<FollowedPoint> points_;
  std::vector<Place> places_;  ///< of the points
  RigidMotion camera_from_scene_;
  double look_at_ = 0.0;  ///< seconds of the clock: when to look for new places
  double wait_ = 0.0;     ///< seconds until the next time
};

}  // namespace glisson::guidance
