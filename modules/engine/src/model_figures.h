// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/engine/command.h"
#include "glisson/model/build.h"

namespace glisson::engine {

/// The state with this model, its figures and its notes.
Applied with_model(const CaseState& state, model::BuiltModel built);

}  // namespace glisson::engine
