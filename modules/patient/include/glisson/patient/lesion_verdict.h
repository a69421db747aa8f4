// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "glisson/volume/label_volume.h"

namespace glisson {

/// How much is drawn: everything; the organ's outline and the lesions' regions only, with the reason; nothing
/// but the reason.
enum class Level { valid, degraded, withdrawn };
const char* level_code(Level level);

/// What a registration does not know of a lesion's place.
struct LesionSpread {
  Label lesion = 0;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of its centre, m2, camera frame
};

/// Why less than the lesion itself is drawn.
enum class LesionReason {
  known,            ///< it is not: its region is small enough
  with_the_whole,   ///< the whole overlay is degraded or withdrawn
  error_unknown,    ///< the registration does not say how far off it may be
  refused_start,    ///< the registration was refused, and used nevertheless
  start_uncertain,  ///< the registration itself does not know it better
  far_from_points,  ///< what is tracked lies far away, and the organ has changed its shape
  long_unseen       ///< nothing near it has been tracked for a while
};
inline constexpr LesionReason kLesionReasons[] = {
    LesionReason::known,         LesionReason::with_the_whole,  LesionReason::error_unknown,
    LesionReason::refused_start, LesionReason::start_uncertain, LesionReason::far_from_points,
    LesionReason::long_unseen};
const char* lesion_reason_code(LesionReason reason);

/// What is known of one lesion in one frame. Metres, seconds, camera frame. A degraded one is drawn as the
/// region that holds it in 95 of 100 cases, a withdrawn one not at all.
struct LesionVerdict {
  Label lesion = 0;
  Level level = Level::withdrawn;
  LesionReason reason = LesionReason::error_unknown;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double radius = 0.0;  ///< of a ball around the centre that holds the lesion
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of the centre; zero: unknown
  double expected = 0.0;                                 ///< mean error that this implies
  double reach = 0.0;    ///< from the centre to the farthest point of its 95 % region; 0: unknown
  double support = 0.0;  ///< from the centre to the tracked points: median of the five nearest
  double unseen = 0.0;   ///< seconds since a tracked point was near
};

}  // namespace glisson
