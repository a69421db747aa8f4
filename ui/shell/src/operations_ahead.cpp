// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/shell/operations_ahead.h"

#include <QMainWindow>

#include "glisson/engine/commands/simulate_operations.h"
#include "glisson/engine/parts/landmarks.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/tissue.h"

namespace glisson::ui {

OperationsAhead::OperationsAhead(EngineBridge& engine, QMainWindow& window)
    : QObject(&window), engine_(engine), window_(window) {
  timer_.setSingleShot(true);
  set_pause(std::chrono::seconds(2));
  connect(&timer_, &QTimer::timeout, this, &OperationsAhead::begin);
  connect(&engine_, &EngineBridge::case_changed, &timer_, qOverload<>(&QTimer::start));
  connect(&engine_, &EngineBridge::tasks_changed, &timer_, qOverload<>(&QTimer::start));
  connect(&engine_, &EngineBridge::about_to_post, this, &OperationsAhead::make_way);
  connect(&engine_, &EngineBridge::finished, this, &OperationsAhead::take);
}

void OperationsAhead::set_pause(std::chrono::milliseconds pause) { timer_.setInterval(pause); }

void OperationsAhead::begin() {
  const auto& snapshot = engine_.snapshot();
  const bool idle = !running_ && engine_.tasks().empty() && !snapshot->tracking && !snapshot->trial;
  const engine::CaseState& now = snapshot->state;
  const bool given_up = now[part::model] == given_up_model_ && now[part::landmarks] == given_up_landmarks_ &&
                        now[part::tissue] == given_up_tissue_;
  if (!idle || given_up || !window_.isWindowModified() || !engine::lacks_operations(now)) return;
  makes_way_ = false;
  posting_ = true;
  running_ = engine_.post(engine::SimulateOperations{});
  posting_ = false;
}

void OperationsAhead::make_way(const engine::CommandTraits& work) {
  if (!running_ || posting_ || work.reads.has(part::operations)) return;  // who reads them waits for them
  const bool would_wait =
      work.lane == engine::Lane::work || work.writes.meets(engine::SimulateOperations{}.traits().reads);
  if (!would_wait && work.live == engine::LiveLane::none) return;
  makes_way_ = true;
  engine_.cancel(*running_);
}

void OperationsAhead::take(const engine::Outcome& outcome) {
  if (running_ != outcome.id) return;
  running_.reset();
  if (outcome.status == engine::Status::done || makes_way_) return;
  given_up_model_ = engine_.state()[part::model];
  given_up_landmarks_ = engine_.state()[part::landmarks];
  given_up_tissue_ = engine_.state()[part::tissue];
}

}  // namespace glisson::ui
