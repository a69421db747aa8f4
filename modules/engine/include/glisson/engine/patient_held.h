// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "glisson/engine/case_state.h"

namespace glisson::engine {

/// Whether a case holds anything that another patient's image must not stand beside: an image, labels, a
/// model or a cloud.
bool holds_patient(const CaseState& state);
/// @param folder the case's, for the message. @throws InputError it holds_patient().
void require_no_patient(const CaseState& state, const std::filesystem::path& folder);

}  // namespace glisson::engine
