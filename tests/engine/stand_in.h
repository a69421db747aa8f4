// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "gate.h"
#include "glisson/engine/commands/start_tracking.h"
#include "glisson/engine/engine.h"
#include "glisson/engine/parts/cloud.h"
#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/landmarks.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/engine/parts/seeds.h"

/// @file
/// A stand-in for the modules, so that a test decides how long a command takes and how it ends.

namespace glisson::test {

/// Every command writes fresh values into the parts that it says it writes.
inline Cancellable<engine::Applied> write_parts(const engine::CaseState& state,
                                                const engine::Command& command, const RunContext& context,
                                                const engine::Services& services) {
  if (command.traits().live != engine::LiveLane::none) return command.apply(state, context, services);
  context.progress(0.5, "half");
  if (context.cancelled()) return {};
  engine::Applied applied;
  applied.state = state;
  const engine::Parts parts = command.traits().writes;
  if (parts.has(part::image)) applied.state[part::image] = std::make_shared<Image>();
  if (parts.has(part::seeds)) applied.state[part::seeds] = std::make_shared<segmentation::Seeds>();
  if (parts.has(part::labels)) applied.state[part::labels] = std::make_shared<LabelMap>();
  if (parts.has(part::model)) applied.state[part::model] = std::make_shared<model::BuiltModel>();
  if (parts.has(part::landmarks)) applied.state[part::landmarks] = std::make_shared<Landmarks>();
  if (parts.has(part::cloud)) applied.state[part::cloud] = std::make_shared<LabelledCloud>();
  if (parts.has(part::registration)) applied.state[part::registration] = std::make_shared<Registration>();
  applied.figures["answer"] = 42.0;
  return applied;
}

class CountingFollower : public engine::Follower {
 public:
  explicit CountingFollower(std::shared_ptr<Gate> gate = nullptr) : gate_(std::move(gate)) {}
  OverlayFrame follow(const engine::LiveInput& input) override {
    if (gate_) gate_->pass();
    OverlayFrame overlay;
    overlay.index = std::get<StereoFrame>(input).index;
    overlay.validity = Validity::valid;
    return overlay;
  }

 private:
  std::shared_ptr<Gate> gate_;
};

inline engine::Engine::Options options(engine::Runner runner) {
  engine::Engine::Options made;
  made.runner = runner;
  made.apply = write_parts;
  made.make_follower = [](const engine::CaseState&, const engine::StartTracking&) {
    return std::make_unique<CountingFollower>();
  };
  return made;
}

/// As write_parts(), with a result.
inline Cancellable<engine::Applied> with_result(const engine::CaseState& state,
                                                const engine::Command& command, const RunContext& context,
                                                const engine::Services& services) {
  auto applied = write_parts(state, command, context, services);
  if (applied) applied->result = std::make_shared<const int>(7);
  return applied;
}

inline StereoFrame numbered(int index) {
  StereoFrame frame;
  frame.index = index;
  return frame;
}

}  // namespace glisson::test
