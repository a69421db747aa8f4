// SPDX-License-Identifier: GPL-3.0-or-later
#include "live_truth.h"

#include <algorithm>

namespace glisson::experiments {

bool shows_another_organ(const LiveFault& fault) { return fault.other_patient || fault.is_mirrored; }

double drawn_error(const LiveFault& fault, const StereoRig& rig, int frame, const Eigen::Vector3d& found,
                   const Eigen::Vector3d& truth) {
  const double off = (found - truth).norm();
  const bool is_swapped = fault.swapped_from >= 0 && frame >= fault.swapped_from;
  if (!is_swapped && !fault.calibration) return off;
  const Camera drawn_by = fault.calibration ? fault.calibration(rig).left : rig.left;
  const Camera& seen_by = is_swapped ? rig.right : rig.left;
  const Eigen::Vector3d there =
      is_swapped ? Eigen::Vector3d(rig.right_from_left.rotation * truth + rig.right_from_left.translation)
                 : truth;
  if (!drawn_by.maps(found)) return kNowhere;
  const Eigen::Vector3d drawn = there.z() * seen_by.ray(drawn_by.project(found));
  return std::max(off, (drawn - there).norm());
}

}  // namespace glisson::experiments
