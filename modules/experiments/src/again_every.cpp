// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/experiments/again_every.h"

#include <utility>

#include "glisson/core/error.h"
#include "glisson/engine/commands/take_registration.h"
#include "glisson/engine/parts/live.h"
#include "glisson/engine/parts/other_registration.h"

namespace glisson::experiments {

AgainEvery::AgainEvery(double seconds, engine::RegisterAgain command, Post post, State state)
    : every_(seconds), command_(std::move(command)), post_(std::move(post)), state_(std::move(state)) {}

std::optional<AgainEvery::Tried> AgainEvery::after(int frame, double seconds, const RunContext& context) {
  if (every_ <= 0.0 || seconds < last_ + every_) return std::nullopt;
  const auto live = state_()[part::live];
  if (!live || !live->tissue_at_start || !is_followed(live->overlay.validity)) return std::nullopt;
  last_ = seconds;
  Tried tried;
  tried.line.frame = frame;
  tried.line.seconds = seconds;
  try {
    post_(command_);
    const auto other = state_()[part::other_registration];
    tried.line.former_gap = other->former_gap;
    tried.line.gap = other->gap;
    tried.line.moved = other->moved;
    const auto take = engine::take_if_better(state_());
    if (take) post_(*take);
    tried.line.is_taken = take.has_value();
  } catch (const Error& problem) {
    if (context.cancelled()) throw;
    tried.problem = problem.what();
  }
  return tried;
}

}  // namespace glisson::experiments
