// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glisson/engine/engine.h"

class QWidget;

namespace glisson::ui {

class EngineBridge;

/// Asks whether the pictures are opened that the case names which has just been opened, where nobody of this
/// computer has chosen them and they are there. Yes is a person's word (SetVideo); else they are left out:
/// that is the answer of Enter and Escape. Does not stop the window.
/// @param outcome of any command; of those that open no case nothing is asked.
/// @return the outcome's notes without what the question tells.
std::vector<std::string> ask_named_video(QWidget* parent, EngineBridge& engine,
                                         const engine::Outcome& outcome);

}  // namespace glisson::ui
