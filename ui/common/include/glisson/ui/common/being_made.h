// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>

#include "glisson/ui/common/engine_bridge.h"

namespace glisson::ui {

/// Whether something at work, or waiting, makes this part of the case anew. A command that is posted now
/// comes after it: what a person says of what is on the screen would be said of what nobody has seen.
/// @param lane on which; none: on any.
bool is_being_made(const EngineBridge& engine, engine::Part part, std::optional<engine::Lane> lane = {});
/// The same without a person's own small steps, which follow each other: something puts another in this
/// part's place, and what a person changes in it meanwhile would meet what nobody has seen.
bool is_being_replaced(const EngineBridge& engine, engine::Part part);
/// Whether a case is on its way that takes the place of what is open.
bool is_case_to_come(const EngineBridge& engine);
/// Why nothing is said of the model meanwhile.
QString model_wait_text();

}  // namespace glisson::ui
