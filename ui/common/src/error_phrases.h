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

// Those of some rooms, each in a file of its own. Where two fit a sentence, the one that stands first counts.
const std::vector<const char*>& general_problems();
const std::vector<const char*>& general_remedies();
const std::vector<const char*>& model_problems();
const std::vector<const char*>& model_remedies();
const std::vector<const char*>& view_problems();
const std::vector<const char*>& view_remedies();
const std::vector<const char*>& work_problems();
const std::vector<const char*>& work_remedies();
const std::vector<const char*>& file_problems();
const std::vector<const char*>& file_remedies();
const std::vector<const char*>& volume_problems();
const std::vector<const char*>& volume_remedies();
const std::vector<const char*>& setting_problems();
const std::vector<const char*>& setting_remedies();

}  // namespace glisson::ui
