// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/engine/case_state.h"

namespace glisson::engine {

/// What a person said of the model after looking at it.
struct ModelCheck {
  bool is_right = false;
};

namespace part {
/// A person's word that the model is right; another model makes it stale.
extern const PartOf<ModelCheck> check;
}  // namespace part

/// Whether a person has looked at this very model and found it right.
bool is_model_checked(const CaseState& state);

}  // namespace glisson::engine
