// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <vector>

#include "glisson/engine/case_state.h"
#include "glisson/volume/label_volume.h"

namespace glisson::engine {

namespace part {
/// Labels that a person has locked: nothing takes a voxel from them or gives them one but undo and redo.
extern const PartOf<std::set<Label>> locks;
}  // namespace part

/// part::locks; empty where none was ever locked.
std::set<Label> locked_in(const CaseState& state);

/// What a command is told to leave alone, with what is locked in the case.
std::vector<Label> with_locks(std::vector<Label> locked, const CaseState& state);

}  // namespace glisson::engine
