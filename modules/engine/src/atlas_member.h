// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "glisson/atlas/member.h"
#include "glisson/engine/case_state.h"

namespace glisson::engine {

/// What a case's model and its person's landmarks show of a liver (CT frame, metres). A landmark that an
/// atlas proposed is no evidence, even where it was accepted, unless a person has placed another since; nor
/// is a margin's piece, or the crest that the model has found, evidence of its whole course.
/// @throws InputError there is no model, or it has no liver surface.
atlas::Member atlas_member(const std::string& name, const CaseState& state);

}  // namespace glisson::engine
