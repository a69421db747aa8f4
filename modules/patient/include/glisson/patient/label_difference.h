// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>

#include "glisson/volume/label_volume.h"

/// @file
/// What becomes of labels when others take their place, told before they do.

namespace glisson {

/// Voxels that a label gains and loses.
struct LabelShift {
  long gained = 0, lost = 0;
  bool operator==(const LabelShift&) const = default;
};

/// How two label volumes differ, and what of a hand's corrections that would undo. Counts are voxels.
struct LabelDifference {
  std::map<Label, LabelShift> labels;  ///< those that change; the background is not among them
  long voxels_changed = 0;             ///< each voxel once
  long hand_voxels = 0;                ///< that a hand has corrected
  long hand_changed = 0;               ///< those of them that would be another
  /// A voxel that changes, in the layer (along k) in which most of them do, closest to their middle there;
  /// where any of a hand's would change, only those count. None: nothing changes.
  std::optional<Eigen::Vector3i> where_most;
};

/// @param mine labels as they are; `offered`: as they would be; `hand`: not 0 where a hand has corrected.
/// @pre all of one grid. Bricks that are shared are not looked at.
LabelDifference label_difference(const LabelVolume& mine, const LabelVolume& offered,
                                 const LabelVolume& hand);

/// What is offered, but for the voxels that a hand has corrected: those stay as they are. @pre all of one
/// grid.
LabelVolume keeping_hand(const LabelVolume& mine, const LabelVolume& offered, const LabelVolume& hand);

}  // namespace glisson
