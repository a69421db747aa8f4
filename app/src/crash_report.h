// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace glisson::app {

/// From now on a crash leaves a report with the stack: version, signal and addresses, nothing of the patient.
/// It stays on this machine; the ten last ones are kept. Where there is no home, there is no report.
/// @param doing the sub-command; empty: the window.
void report_crashes(const std::filesystem::path& folder, const char* doing);

}  // namespace glisson::app
