// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>

#include "glisson/engine/load_trial.h"
#include "glisson/fem/tissue.h"
#include "glisson/model/build.h"
#include "glisson/patient/patient_model.h"

namespace glisson::engine {

/// The load trial that is on, if any: newest pull wins, steps at a pace, none while the organ rests. Guarded
/// by the engine's mutex, but for the mechanics, which belong to the thread that takes the steps.
class TrialLane {
 public:
  using Clock = std::chrono::steady_clock;

  explicit TrialLane(double pace_seconds);

  /// The mechanics of the next trial (null: none). The steps' thread, without the lock.
  void set_mechanics(std::shared_ptr<LoadTrial> mechanics) { mechanics_ = std::move(mechanics); }

  // With the lock:
  void begin(const CaseState& made_from);
  void end();
  bool is_on() const { return on_; }
  /// Whether the organ that is pulled is still the case's.
  bool fits(const CaseState& state) const;
  /// @throws PreconditionError what is not a point of the surface, or not finite; the former pull stays.
  void submit(std::optional<TrialPull> pull);
  /// When the next step is due; empty: nothing to do.
  std::optional<Clock::time_point> next() const;
  bool is_due() const { return next() && *next() <= Clock::now(); }
  /// Whether the newest pull is in no published step yet.
  bool is_behind() const { return on_ && shown_ != submitted_; }
  /// One step with the newest pull; lets go of the lock meanwhile. Null: the trial was ended in the meantime.
  std::shared_ptr<const TrialState> step(std::unique_lock<std::mutex>& lock);

 private:
  void count(TrialState& state, Clock::time_point started);

  Clock::duration pace_;
  std::shared_ptr<LoadTrial> mechanics_;
  bool on_ = false, awake_ = false;
  std::uint64_t submitted_ = 0, shown_ = 0;  ///< pulls: so many came, so many are (or were) in a step
  std::optional<TrialPull> pull_;
  Clock::time_point next_;
  std::deque<Clock::time_point> recent_;  ///< ends of the last second's steps
  int steps_ = 0;
  std::shared_ptr<const model::BuiltModel> model_;
  std::shared_ptr<const Landmarks> landmarks_;
  std::shared_ptr<const fem::Tissue> tissue_;
};

}  // namespace glisson::engine
