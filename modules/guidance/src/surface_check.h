// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "glisson/geometry/camera.h"
#include "glisson/patient/patient_model.h"
#include "glisson/patient/picture.h"
#include "stereo_follower.h"

namespace glisson::guidance {

/// What a fresh stereo surface says of where the model is drawn.
struct SurfaceEvidence {
  int predicted = 0;       ///< places of the grid where the organ should be seen
  int seen = 0;            ///< of these, with a depth by stereo
  double supported = 0.0;  ///< share of the predicted ones where stereo sees the organ
  /// Share by which it sees less of the organ than it did of these same places of the material in the pairs
  /// that were learnt: what hides them. 0: too few of them were in sight then.
  double missing = 0.0;
  double behind = 0.0;  ///< share of those, well inside the outline, where it sees something farther away
  double before = 0.0;  ///< the same, nearer: covered, or the organ itself:
  double lifted = 0.0;  ///< of `before`, what is the organ (lifted_places())
  double gap = 0.0;     ///< rms over regions of the median distance, expected standard deviations
  /// Two neighbouring regions that are off to the same side count as much as the smaller of the two, in
  /// standard deviations; this is the largest over all such pairs. It finds a part of the organ that is
  /// elsewhere, which `gap` dilutes, and ignores a single region, which may be a wrong match.
  double local = 0.0;
  double pull = 0.0;  ///< metres; see Evidence
  double pull_sigma = 0.0;
  /// Where it sees tissue of the organ: these places of the material as they lie in the shape that check()
  /// was given, metres.
  std::vector<Eigen::Vector3d> tissue;
  Eigen::Vector3d eye = Eigen::Vector3d::Zero();  ///< the left camera's, as the organ's motion takes it there
};

/// Compares the predicted surface with one that stereo makes of the pair alone: none of the tracked points,
/// none of the former frames; but for `missing`. The fine surface is used where the model has one. Not
/// thread-safe.
class SurfaceCheck {
 public:
  /// @param mask empty, or non-zero where tissue may be seen (left picture).
  SurfaceCheck(const PatientModel& model, const StereoRig& rig, const Picture& mask);
  ~SurfaceCheck();
  /// @param nodes_in_camera the overlay's at this pair's moment.
  /// @param shape any other shape of the same nodes, for `tissue`; empty: none.
  /// @param followed the points that are followed in this pair.
  /// @param not_liver empty, or of the left picture's size and non-zero where no tissue is to be kept.
  /// @throws InputError pictures of another size.
  SurfaceEvidence check(const Picture& left, const Picture& right, const Points& nodes_in_camera,
                        const Points& shape = {}, const std::vector<FollowedPoint>& followed = {},
                        const Picture& not_liver = {});
  /// The last pair shows how much of each place stereo sees: nothing hid the organ, and it was found.
  /// @pre check() was called, and is not at work.
  void learn();
  /// What was learnt is another start's.
  void forget();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace glisson::guidance
