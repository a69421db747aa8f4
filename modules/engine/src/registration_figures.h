// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glisson/core/json_file.h"
#include "glisson/engine/case_state.h"
#include "glisson/registration/examined_registration.h"

namespace glisson::engine {

/// What a registration comes to: residuals, forces, expected errors, findings.
Figures figures_of(const registration::ExaminedRegistration& examined);
/// What is known of one by itself, as where it was not made but chosen.
Figures figures_of(const Registration& registration);
/// What is noted of one besides its doubts, of the state's landmarks and looks of which it was made.
std::vector<std::string> notes_of(const CaseState& state, const PatientModel& model,
                                  const registration::RegisterOptions& options,
                                  const registration::ExaminedRegistration& examined);
/// Its doubts, and then what else was noted when it was made.
std::vector<std::string> told_of(const Registration& registration);

}  // namespace glisson::engine
