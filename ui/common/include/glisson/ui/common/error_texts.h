// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <string>
#include <string_view>
#include <vector>

namespace glisson::ui {

/// The modules' sentence on an error in the person's language. Sentences on files, folders and cases are
/// known whole; of all others the problem and the remedy apart, and what is not known stays as it is, in
/// English.
QString error_text(std::string_view sentence);
bool is_error_known(std::string_view sentence);
/// What may be logged of such a sentence: the problem and the remedy as they stand in the modules, where they
/// are known ("_" where they name something), nothing else: any other word may be a patient's name, in a
/// file's name or a field. Not known: "another error".
std::string logged_error(std::string_view sentence);
/// The problems and remedies that are known, as they stand in the modules.
std::vector<const char*> error_phrases();

}  // namespace glisson::ui
