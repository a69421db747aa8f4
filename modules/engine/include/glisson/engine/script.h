// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "glisson/engine/engine.h"

namespace glisson::engine {

/// Commands one after another on an inline engine: what command lines and experiments are made of. Progress
/// goes to the context, whose cancel ends the running command. Not thread-safe.
class Script {
 public:
  explicit Script(const RunContext& context);
  /// Progress goes there from now on, and cancel comes from there: for a script that is a part of something.
  void report_to(const RunContext& context) { context_ = context; }

  /// Does a command. Empty when cancelled. @throws Error with the engine's sentence.
  Cancellable<Outcome> run(Command command);
  /// Follows one input, however long it takes. Empty when cancelled. @pre tracking was started.
  Cancellable<OverlayFrame> follow(LiveInput input);

  const CaseState& state() const { return snapshot_->state; }

 private:
  RunContext context_;
  std::unique_ptr<Engine> engine_;
  std::shared_ptr<const Snapshot> snapshot_;
};

}  // namespace glisson::engine
