// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

/// @file
/// What errors of the modules say, for translators: an InputError is "FILE: FIELD: problem. Remedy.", so the
/// two are translated apart, and a remedy once for all problems. %1, %2, ... stand for values. Each phrase
/// stands in the modules' sources; a test looks there.

namespace glisson::ui {

const std::vector<const char*>& known_problems();
const std::vector<const char*>& known_remedies();

}  // namespace glisson::ui
