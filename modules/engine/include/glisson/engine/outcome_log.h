// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "glisson/core/log.h"
#include "glisson/engine/engine.h"

namespace glisson::engine {

/// How a command ended, for the log: its code, its status and its time; of an error and of notes what names
/// nobody.
/// @param told what may be logged of an error's sentence.
void log_outcome(const Log& log, const Outcome& outcome,
                 const std::function<std::string(std::string_view sentence)>& told);

}  // namespace glisson::engine
