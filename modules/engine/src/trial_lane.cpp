// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial_lane.h"

#include <exception>
#include <utility>

#include "glisson/core/termination.h"
#include "glisson/engine/parts/landmarks.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/tissue.h"

namespace glisson::engine {

TrialLane::TrialLane(double pace_seconds)
    : pace_(std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(pace_seconds))) {}

void TrialLane::begin(const CaseState& made_from) {
  on_ = true;
  awake_ = false;
  shown_ = submitted_;
  pull_.reset();
  recent_.clear();
  steps_ = 0;
  model_ = made_from[part::model];
  landmarks_ = made_from[part::landmarks];
  tissue_ = made_from[part::tissue];
}

void TrialLane::end() {
  on_ = awake_ = false;
  pull_.reset();
  model_.reset();
  landmarks_.reset();
  tissue_.reset();
}

bool TrialLane::fits(const CaseState& state) const {
  return !on_ || (state[part::model] == model_ && state[part::landmarks] == landmarks_ &&
                  state[part::tissue] == tissue_);
}

void TrialLane::submit(std::optional<TrialPull> pull) {
  if (!on_) return;
  if (pull) pull->require_on_surface(model_ ? model_->model.surface.mesh.triangle_count() : 0);
  if (!awake_) recent_.clear();  // the rate is not that of a rest
  pull_ = std::move(pull);
  awake_ = true;
  ++submitted_;
}

std::optional<TrialLane::Clock::time_point> TrialLane::next() const {
  if (!on_ || !awake_) return {};
  return next_;
}

std::shared_ptr<const TrialState> TrialLane::step(std::unique_lock<std::mutex>& lock) {
  const std::optional<TrialPull> pull = pull_;
  const std::uint64_t taken = submitted_;
  const Clock::time_point started = Clock::now();
  lock.unlock();
  auto state = std::make_shared<TrialState>();
  try {
    *state = mechanics_->step(pull);
  } catch (const std::exception&) {
    state->termination = Termination::diverged;  // whatever went wrong, there is no shape to be shown
  }
  lock.lock();
  if (!on_) return nullptr;
  shown_ = taken;
  count(*state, started);
  if (state->termination)
    end();
  else if (!is_behind() && !pull_ && state->nodes.rows() == 0)
    awake_ = false;
  return state;
}

void TrialLane::count(TrialState& state, Clock::time_point started) {
  next_ = started + pace_;
  const Clock::time_point now = Clock::now();
  recent_.push_back(now);
  while (now - recent_.front() > std::chrono::seconds(1)) recent_.pop_front();
  const double seconds = std::chrono::duration<double>(now - recent_.front()).count();
  if (recent_.size() > 1 && seconds > 0.0) state.hertz = static_cast<double>(recent_.size() - 1) / seconds;
  state.steps = ++steps_;
}

}  // namespace glisson::engine
