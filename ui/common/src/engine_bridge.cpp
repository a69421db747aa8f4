// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/common/engine_bridge.h"

#include <algorithm>

#include "glisson/engine/parts/live.h"

namespace glisson::ui {
namespace {

/// Whether anything but the live picture differs.
bool case_differs(const engine::Snapshot& a, const engine::Snapshot& b) {
  if (a.tracking != b.tracking || a.state.path != b.state.path) return true;
  for (const engine::Part part : engine::all_parts()) {
    if (part.type().spec().is_live) continue;
    if (!a.state.shares(part, b.state) || a.stage(part) != b.stage(part)) return true;
  }
  return false;
}

/// Whether it brings what it is about along, from a file: of several that are given together the next ones
/// are meant for the case that the first one opens. All else is about what is on screen: so is what is read
/// by a part of the case, as a frame of its video.
bool comes_from_a_file(const engine::CommandTraits& traits) {
  if (traits.notice != engine::Notice::files) return false;
  if (traits.reads.empty() && traits.writes.empty()) return true;  // it is about no case
  const auto is_read = [&](const engine::Need& need) { return traits.reads.has(need.part); };
  if (std::any_of(traits.needs.begin(), traits.needs.end(), is_read)) return false;
  const auto& parts = engine::all_parts();
  return std::any_of(parts.begin(), parts.end(), [&](const engine::Part part) {
    return traits.writes.has(part) && part.type().is_saved();
  });
}

}  // namespace

EngineBridge::EngineBridge(engine::Engine::Options options, QObject* parent) : QObject(parent) {
  options.wake = [this] {
    // Many wake-ups, one call: whoever finds the flag down raises it and queues.
    if (!call_is_queued_.exchange(true))
      QMetaObject::invokeMethod(
          this, [this] { deliver(); }, Qt::QueuedConnection);
  };
  engine_ = std::make_unique<engine::Engine>(std::move(options));
  snapshot_ = engine_->snapshot();
}

EngineBridge::~EngineBridge() {
  engine_.reset();  // joins the engine's threads, so that nothing wakes a bridge that is gone
}

engine::CommandId EngineBridge::post(engine::Command command) {
  Task task;
  task.traits = command.traits();
  emit about_to_post(task.traits);
  std::optional<std::uint64_t> meant_for = snapshot_->case_number;
  if (comes_from_a_file(task.traits)) meant_for.reset();
  task.id = engine_->post(std::move(command), meant_for);
  tasks_.push_back(task);
  emit tasks_changed();
  return task.id;
}

void EngineBridge::cancel(engine::CommandId id) { engine_->cancel(id); }

void EngineBridge::submit_frame(StereoFrame frame) { engine_->submit_frame(std::move(frame)); }

void EngineBridge::submit_pull(const std::optional<engine::TrialPull>& pull) { engine_->submit_pull(pull); }

bool EngineBridge::is_busy(engine::CommandId id) const {
  return std::any_of(tasks_.begin(), tasks_.end(), [&](const Task& task) { return task.id == id; });
}

void EngineBridge::deliver() {
  call_is_queued_.store(false);  // before reading: what comes from now on queues again
  const std::shared_ptr<const engine::Snapshot> previous = snapshot_;
  // Events first: the snapshot that is read afterwards is at least as new as they are.
  const std::vector<engine::Event> events = engine_->take_events();
  snapshot_ = engine_->snapshot();
  if (case_differs(*previous, *snapshot_)) emit case_changed();
  if (previous->state[part::live] != snapshot_->state[part::live]) emit live_changed();
  if (previous->trial != snapshot_->trial) emit trial_changed();
  if (previous->evolving != snapshot_->evolving) emit evolving_changed();
  for (const engine::Event& event : events) take(event);
  if (!events.empty()) emit tasks_changed();
}

void EngineBridge::take(const engine::Event& event) {
  if (const auto* progress = std::get_if<engine::Progress>(&event)) {
    for (Task& task : tasks_)
      if (task.id == progress->id) {
        task.fraction = progress->fraction;
        task.stage = progress->stage;
      }
    return;
  }
  const auto& outcome = std::get<engine::Outcome>(event);
  std::erase_if(tasks_, [&](const Task& task) { return task.id == outcome.id; });
  emit finished(outcome);
}

}  // namespace glisson::ui
