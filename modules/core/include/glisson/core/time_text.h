// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace glisson {

/// The present time, in strftime's format; at most 63 letters. Empty: the machine cannot say.
std::string local_time_text(const char* format);
/// The same in UTC, whatever the machine's time zone.
std::string utc_time_text(const char* format);

}  // namespace glisson
