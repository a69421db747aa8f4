// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "followed_body.h"
#include "glisson/guidance/tracker.h"
#include "glisson/registration/force_follower.h"

namespace glisson::guidance {

/// Brings the followed organ to a cloud: by contact forces, or by the springs of eq. 14. Not thread-safe.
class CloudFollower {
 public:
  CloudFollower(const PatientModel& model, const Registration& start, const TrackerOptions& options);

  /// A cloud that is not valid, or that lies elsewhere than the organ was, is forgotten: the organ stays
  /// where it was.
  /// @param steps of the springs, with new pairs each. @param overlay its pairs, residual and cloud faults
  /// are filled in.
  Validity follow(const LabelledCloud& cloud, int steps, FollowedBody& body, OverlayFrame& overlay);
  /// The points of the last cloud that could be used: sound_cloud().
  const PointsIn<CameraFrame>& seen() const { return seen_; }

 private:
  Validity bring(const LabelledCloud& cloud, int steps, FollowedBody& body, OverlayFrame& overlay);
  Validity by_forces(const LabelledCloud& cloud, FollowedBody& body, OverlayFrame& overlay);
  Validity by_springs(const LabelledCloud& cloud, int steps, FollowedBody& body, OverlayFrame& overlay) const;

  TrackerOptions options_;
  bool from_camera_;  ///< the clouds; or they are in the model's frame
  std::optional<registration::ForceFollower> forces_;
  PointsIn<CameraFrame> seen_;
  CloudFaults faults_;  ///< of all clouds
};

}  // namespace glisson::guidance
