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

template <class Counts>
bool is_written(const EngineBridge& engine, engine::Part part, const Counts& counts) {
  const auto& tasks = engine.tasks();
  return std::any_of(tasks.begin(), tasks.end(),
                     [&](const Task& task) { return task.traits.writes.has(part) && counts(task.traits); });
}

}  // namespace

bool is_being_made(const EngineBridge& engine, engine::Part part, std::optional<engine::Lane> lane) {
  return is_written(engine, part,
                    [lane](const engine::CommandTraits& work) { return !lane || work.lane == *lane; });
}

bool is_being_replaced(const EngineBridge& engine, engine::Part part) {
  return is_written(engine, part,
                    [](const engine::CommandTraits& work) { return work.notice != engine::Notice::quiet; });
}

bool is_case_to_come(const EngineBridge& engine) {
  return std::ranges::any_of(engine.tasks(), [](const Task& task) { return task.traits.replaces_case(); });
}

QString model_wait_text() { return BeingMade::tr("A new model is being made: look at it first."); }

}  // namespace glisson::ui
