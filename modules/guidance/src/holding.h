// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "anchored_points.h"
#include "glisson/geometry/rigid.h"
#include "glisson/patient/patient_model.h"
#include "glisson/registration/moving_surface.h"
#include "scenery.h"

namespace glisson::guidance {

/// Where what holds the organ (cava, bed, ligaments) stands before the camera. It goes with the scope, and
/// with the breath, which moves the organ and all that it hangs on nearly as one; a tool that lifts or
/// presses the organ moves a part of it and leaves what holds it where it is. So it is the one rigid motion
/// since the registration that most of the followed points agree on, near to where the scene beside the organ
/// has it.
class Holding {
 public:
  /// @param shape registered nodes, left camera's frame, metres.
  Holding(const PatientModel& model, const Points& shape, const StereoRig& rig);

  /// The registered shape is another one.
  void take(const Points& shape) { rest_.move(shape); }
  /// The organ was found elsewhere: nothing is known of the scene that is seen now.
  void found(const RigidMotion& motion) {
    from_start_ = motion.after(from_start_);
    begin_scenery();
  }
  /// @param now the organ's surface in the last frame.
  /// @return how what holds the organ has moved in the camera's frame since the last frame.
  RigidMotion follow(const StereoFollower& follower, const AnchoredPoints& anchors,
                     const registration::MovingSurface& now);
  Scenery& scenery() { return scenery_; }

 private:
  void begin_scenery();

  registration::MovingSurface rest_;  ///< as registered
  Scenery scenery_;
  RigidMotion from_start_;    ///< the camera's frame now from that of the registration
  RigidMotion scene_before_;  ///< from_start_ when the scenery began
  double way_ = 0.0;          ///< of the organ before the camera by the scope's motion since then, metres
};

/// What is known of a motion beforehand.
struct ExpectedMotion {
  RigidMotion motion;
  double deviation = 0.0;  ///< metres at the organ, each axis
  double turns = 0.0;      ///< radians, about each axis
};

/// The rigid motion that most pairs agree on, with Geman and McClure's weights.
/// @param rest N x 3, metres: where the points were. @param points where they are, in the camera's frame.
/// @param start where to begin. @param expected empty: nothing is known.
RigidMotion common_to_most(const Points& rest, const std::vector<FollowedPoint>& points,
                           const RigidMotion& start, const std::optional<ExpectedMotion>& expected);

}  // namespace glisson::guidance
