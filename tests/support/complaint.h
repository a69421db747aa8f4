// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "glisson/core/error.h"

namespace glisson::test {

/// The message of the error that the call throws; empty when it throws none. Other exceptions pass.
template <class Expected = InputError, class Call>
std::string complaint(Call call) {
  try {
    call();
  } catch (const Expected& error) {
    return error.what();
  }
  return {};
}

/// What of a file is refused: the field that the InputError of reading it names; "none" when it is read, "no
/// remedy" when the error offers none, "other: ..." on another error.
template <class Call>
std::string refused_field(Call read) {
  try {
    read();
    return "none";
  } catch (const InputError& error) {
    return error.remedy().empty() ? "no remedy" : error.field();
  } catch (const std::exception& error) {
    return std::string("other: ") + error.what();
  }
}

}  // namespace glisson::test
