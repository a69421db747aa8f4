// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "glisson/ui/common/panel.h"

namespace glisson::ui {

/// Ends what a panel does beside the engine (Panel::wind_up) while a box says so, which a person can put
/// away.
/// @param then it went well, and the box is still there. @param failed what went wrong.
/// @return whether there is anything to wait for.
bool wind_up(const std::vector<Panel*>& panels, QWidget* window, const std::function<void()>& then,
             const std::function<void(const QString& problem)>& failed);

}  // namespace glisson::ui
