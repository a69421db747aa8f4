// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/script.h"

#include <utility>

#include "glisson/core/error.h"
#include "glisson/engine/parts/live.h"

namespace glisson::engine {

Script::Script(const RunContext& context) : context_(context) {
  Engine::Options options;
  options.runner = Runner::inline_;
  options.seed = context.seed();
  options.progress = [this](const Progress& progress) {
    context_.progress(progress.fraction, progress.stage);
    if (context_.cancelled()) engine_->cancel(progress.id);
  };
  engine_ = std::make_unique<Engine>(std::move(options));
  snapshot_ = engine_->snapshot();
}

Cancellable<Outcome> Script::run(Command command) {
  if (context_.cancelled()) return {};
  Outcome outcome = engine_->wait(engine_->post(std::move(command)));
  engine_->take_events();
  snapshot_ = engine_->snapshot();
  if (outcome.status == Status::cancelled) return {};
  if (outcome.status == Status::failed) throw Error(outcome.error);
  return outcome;
}

Cancellable<OverlayFrame> Script::follow(LiveInput input) {
  require(snapshot_->tracking, "follow needs tracking to be started");
  if (context_.cancelled()) return {};
  engine_->submit_frame(std::move(input));
  snapshot_ = engine_->snapshot();
  return snapshot_->state[part::live]->overlay;
}

}  // namespace glisson::engine
