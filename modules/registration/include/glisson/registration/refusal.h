// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <string>

#include "glisson/patient/registration.h"

/// @file
/// A registration that evidence contradicts says so among its doubts, which go with it wherever it goes.

namespace glisson::registration {

/// The doubts' codes.
inline constexpr const char* kRefused = "refused";
inline constexpr const char* kRefusalAccepted = "refusal_accepted";  ///< somebody wants it nevertheless
inline constexpr const char* kLesionError = ".error_large";          ///< behind a lesion's name

/// @param code the whole of it, with its values if it has any.
inline bool has_doubt(const Registration& registration, const char* code) {
  return std::find(registration.doubts.begin(), registration.doubts.end(), code) != registration.doubts.end();
}
/// Refused, and nobody has accepted it: no overlay may start from it.
inline bool is_refused(const Registration& registration) { return has_doubt(registration, kRefused); }
/// Whether anything speaks against where the organ as a whole is. A lesion that is less known than the organ
/// has a region and a level of its own.
inline bool is_in_doubt(const Registration& registration) {
  return std::any_of(registration.doubts.begin(), registration.doubts.end(), [](const std::string& doubt) {
    return !doubt.substr(0, doubt.find(' ')).ends_with(kLesionError);
  });
}
/// How it ended, for files and figures: "refused", else its termination's code.
inline const char* ending_code(const Registration& registration) {
  return is_refused(registration) ? kRefused : termination_code(registration.termination);
}
/// Goes on with it although it was refused. The other doubts stay.
inline void accept_refusal(Registration& registration) {
  std::replace(registration.doubts.begin(), registration.doubts.end(), std::string(kRefused),
               std::string(kRefusalAccepted));
}

}  // namespace glisson::registration
