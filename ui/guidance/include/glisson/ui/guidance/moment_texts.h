// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace glisson::engine {
struct KeptMoment;
}

namespace glisson::ui {

/// "frame 120, 4.8 s, kept 2026-01-31 11:20:30", the last in the machine's time zone.
QString moment_time(const engine::KeptMoment& moment);
/// The same in a list's few letters: "frame 120, 2026-01-31 11:20:30"
QString moment_place(const engine::KeptMoment& moment);
/// "valid", "outline only: part of the organ is covered", "no overlay: ..."
QString moment_level(const engine::KeptMoment& moment);

}  // namespace glisson::ui
