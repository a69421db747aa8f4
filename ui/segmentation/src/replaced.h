// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "glisson/ui/common/engine_bridge.h"

namespace glisson::ui {

/// Whether work is on its way that puts something else in the place of a part. What a person changes in it
/// meanwhile would wait, and meet what that person has not seen. Own small edits are not meant: they follow
/// each other.
inline bool is_replaced(const EngineBridge& engine, engine::Part part) {
  return std::any_of(engine.tasks().begin(), engine.tasks().end(), [part](const Task& task) {
    return task.traits.writes.has(part) && task.traits.notice != engine::Notice::quiet;
  });
}

}  // namespace glisson::ui
