// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/common/being_made.h"

#include <QCoreApplication>
#include <algorithm>

namespace glisson::ui {
namespace {

/// Context of these sentences for translators.
class BeingMade {
  Q_DECLARE_TR_FUNCTIONS(BeingMade)
};

}  // namespace

bool is_being_made(const EngineBridge& engine, engine::Part part, std::optional<engine::Lane> lane) {
  const auto& tasks = engine.tasks();
  return std::any_of(tasks.begin(), tasks.end(), [&](const Task& task) {
    return task.traits.writes.has(part) && (!lane || task.traits.lane == *lane);
  });
}

QString model_wait_text() { return BeingMade::tr("A new model is being made: look at it first."); }

}  // namespace glisson::ui
