// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/engine/case_state.h"
#include "glisson/registration/register_model.h"

namespace glisson::engine {

/// Options of a registration with what the case says: whether a person has placed its landmarks, how stiff
/// the tissue is where `options` say nothing of it, and whether the model ends with the image, inside the
/// organ.
/// @pre the state has a model
registration::RegisterOptions options_of(const CaseState& state, registration::RegisterOptions options);
/// The same for the case's own cloud: the earlier looks that are joined to it, too.
registration::RegisterOptions options_with_looks(const CaseState& state,
                                                 registration::RegisterOptions options);

}  // namespace glisson::engine
