// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glisson/core/json_file.h"
#include "glisson/registration/examined_registration.h"

namespace glisson::engine {

/// What a registration comes to: residuals, forces, expected errors, findings.
Figures figures_of(const registration::ExaminedRegistration& examined);
/// What is known of one by itself, as where it was not made but chosen.
Figures figures_of(const Registration& registration);
/// Its doubts, and then what else was noted when it was made.
std::vector<std::string> told_of(const Registration& registration);

}  // namespace glisson::engine
