// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "glisson/core/log.h"
#include "glisson/engine/engine.h"

namespace glisson::engine {

/// How a command ended, for the log: its code, its status and its time; of an error and of notes what names
/// nobody.
void log_outcome(const Log& log, const Outcome& outcome);

}  // namespace glisson::engine
