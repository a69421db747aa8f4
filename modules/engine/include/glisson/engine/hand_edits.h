// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>

#include "glisson/core/error.h"
#include "glisson/engine/case_state.h"
#include "glisson/volume/label_volume.h"

namespace glisson::engine {

/// What becomes of labels that a hand has corrected when they are found anew.
enum class OverHandWork {
  refuse,     ///< nothing is computed
  offer,      ///< the labels stay, the new ones become the part `offer` (see DecideSegmentation)
  keep_hand,  ///< the voxels that a hand has corrected stay, all else is replaced
  replace
};

/// Labels that a hand has worked on since growth last changed them, or all were imported; what was undone
/// does not count, nor what lies around them and gave or took the voxels. Steps that the history had no room
/// for are not known. Growth that kept what a hand had corrected changes nothing of that.
std::set<Label> edited_by_hand(const CaseState& state);

/// Those of them that a hand has drawn itself: clicks that correct do not count (see CorrectAround), and a
/// lesion that was found anew by one is not drawn any more.
std::set<Label> drawn_by_hand(const CaseState& state);

/// 1 where those corrections changed a voxel that growth has not changed since, 0 elsewhere; on the labels'
/// grid. @pre the state has labels.
LabelVolume hand_corrected(const CaseState& state);

/// Why such labels are not found anew unasked, and what to do. @pre not empty.
InputError hand_work_error(const std::set<Label>& labels);

}  // namespace glisson::engine
