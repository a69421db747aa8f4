// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <string_view>

namespace glisson::ui {

/// The engine's sentence on an error in the person's language, where it is one of those that are known here (of
/// files, folders and cases); every other as it is, in English.
QString error_text(std::string_view sentence);
bool is_error_known(std::string_view sentence);

}  // namespace glisson::ui
