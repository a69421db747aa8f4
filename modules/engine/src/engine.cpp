// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/engine.h"

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <exception>
#include <filesystem>
#include <map>
#include <mutex>
#include <thread>
#include <utility>

#include "glisson/core/error.h"
#include "glisson/core/failure_sentence.h"
#include "glisson/core/stopwatch.h"
#include "glisson/engine/parts/live.h"
#include "job.h"
#include "outcome_store.h"
#include "stamps.h"
#include "trial_lane.h"

namespace glisson::engine {
struct Engine::Impl final : LiveLanes {
  explicit Impl(Options given)
      : options(std::move(given)), current(std::make_shared<Snapshot>()), trial(options.trial_seconds) {}

  Options options;

  mutable std::mutex mutex;          // guards everything below but follower and mechanics
  std::condition_variable changed;   // for the lanes: a job or a frame came, a job ended, or stop
  std::condition_variable finished;  // for waiters
  bool stopping = false;
  CommandId next_id = 1;
  std::uint64_t revision = 0;
  std::uint64_t cases = 0;                   // that were replaced by another
  std::deque<std::shared_ptr<Job>> waiting;  // in the order of post()
  std::vector<std::shared_ptr<Job>> running;
  std::shared_ptr<const Snapshot> current;
  std::deque<Event> events;
  bool wake_sent = false;
  OutcomeStore outcomes;
  CommandId evolving_of = 0;       // the command whose contour is shown; 0: none
  std::optional<LiveInput> frame;  // newest wins
  bool following = false;          // a frame is being followed just now
  LiveState live;                  // counters since tracking began
  TrialLane trial;                 // its mechanics are touched by the edits lane only

  std::shared_ptr<Follower> follower;  // touched by the edits lane only
  std::jthread edits_thread, work_thread;

  void wake(std::unique_lock<std::mutex>& lock) {
    changed.notify_all();
    if (wake_sent || !options.wake) return;
    wake_sent = true;
    const std::function<void()> call = options.wake;  // the engine's end takes it away
    lock.unlock();
    call();
    lock.lock();
  }

  void publish(CaseState state, std::string cause) {
    auto snapshot = std::make_shared<Snapshot>();
    snapshot->revision = ++revision;
    snapshot->case_number = cases;
    snapshot->cause = std::move(cause);
    snapshot->state = std::move(state);
    for (const Part part : all_parts())
      if (snapshot->state.has(part)) snapshot->stages[part] = stage_state(snapshot->state, part);
    snapshot->tracking = current->tracking;
    snapshot->evolving = current->evolving;
    if (trial.fits(snapshot->state))
      snapshot->trial = current->trial;
    else
      trial.end();
    current = std::move(snapshot);
  }

  /// The snapshot with what does not belong to the case changed: its revision stays.
  template <typename Change>
  void amend(const Change& change) {
    auto amended = std::make_shared<Snapshot>(*current);
    change(*amended);
    current = std::move(amended);
  }

  /// The first waiting job of this lane that conflicts with no job waiting before it (Job::conflicts_with)
  /// and need not wait for a running one (Job::must_wait_for). Null: there is none.
  std::shared_ptr<Job> take_ready(Lane lane) {
    for (std::size_t i = 0; i < waiting.size(); ++i) {
      const std::shared_ptr<Job> job = waiting[i];
      if (job->traits().lane != lane) continue;
      const auto blocks = [&](const std::shared_ptr<Job>& other) { return job->conflicts_with(*other); };
      const auto delays = [&](const std::shared_ptr<Job>& other) { return job->must_wait_for(*other); };
      const auto before = waiting.begin() + static_cast<std::ptrdiff_t>(i);
      if (std::any_of(running.begin(), running.end(), delays) || std::any_of(waiting.begin(), before, blocks))
        continue;
      waiting.erase(before);
      running.push_back(job);
      return job;
    }
    return nullptr;
  }

  void report_progress(const Job& job, double fraction, std::string_view stage) {
    Progress progress{job.id, std::string(job.command.code()), fraction, std::string(stage)};
    if (options.runner == Runner::inline_ && options.progress) options.progress(progress);
    std::unique_lock lock(mutex);
    const auto same = std::find_if(events.rbegin(), events.rend(), [&](const Event& event) {
      const auto* old = std::get_if<Progress>(&event);
      return old != nullptr && old->id == job.id;
    });
    if (same != events.rend())
      *same = std::move(progress);
    else
      events.emplace_back(std::move(progress));
    wake(lock);
  }

  /// Takes over what a command made. Only the parts that it writes; the rest may have moved on meanwhile.
  void commit(const Job& job, const CaseState& base, Applied&& applied) {
    const CommandTraits& traits = job.traits();
    if (traits.writes.empty() && applied.state.path == base.path) return;  // nothing has changed
    if (traits.replaces_case()) ++cases;
    CaseState state = current->state;
    state.path = applied.state.path != base.path ? applied.state.path : state.path;
    if (applied.keeps_stamps) {
      for (const Part part : all_parts()) revision = std::max(revision, applied.state.stamp(part).revision);
      state = std::move(applied.state);
    } else {
      take_over(state, traits, base, applied.state, revision);
    }
    publish(std::move(state), std::string(job.command.code()));
  }

  /// Everything of a command from start to outcome. Called without the lock, on the lane's thread.
  void run(const std::shared_ptr<Job>& job) {
    CaseState base;
    {
      const std::scoped_lock lock(mutex);
      base = current->state;
      if (!job->is_meant_for(cases)) job->cancel->request();
    }
    Outcome outcome = outcome_of(*job);
    const Stopwatch watch;
    std::optional<Applied> applied;
    const RunContext context(
        [this, &job](double fraction, std::string_view stage) { report_progress(*job, fraction, stage); },
        job->cancel, options.seed);
    try {
      if (!job->cancel->requested()) applied = perform(base, *job, context);
      if (!applied) outcome.status = Status::cancelled;
    } catch (const std::exception& failure) {
      outcome.status = Status::failed;
      outcome.error = sentence_of(failure, outcome.command);
    }
    std::unique_lock lock(mutex);
    if (evolving_of == job->id) put_evolving(0, nullptr);
    const bool is_final = applied && applied->is_final;
    if (outcome.status == Status::done && job->cancel->requested() && !is_final)
      outcome.status = Status::cancelled;
    if (outcome.status == Status::done) {
      outcome.figures = std::move(applied->figures);
      outcome.notes = std::move(applied->notes);
      outcome.result = std::move(applied->result);
      settle_live(job->traits(), *applied);
      commit(*job, base, std::move(*applied));
    }
    outcome.seconds = watch.seconds();
    std::erase(running, job);
    finish(lock, std::move(outcome));
  }

  static Outcome outcome_of(const Job& job) {
    Outcome outcome;
    outcome.id = job.id;
    outcome.command = job.command.code();
    outcome.traits = job.traits();
    return outcome;
  }

  Cancellable<Applied> perform(const CaseState& base, const Job& job, const RunContext& context) {
    // Where nobody looks before the command ends, no contour is drawn.
    const bool is_seen = options.runner == Runner::threaded || options.wake;
    std::function<void(const LabelVolume&)> show;
    if (is_seen) show = [this, id = job.id](const LabelVolume& liver) { show_evolving(id, liver); };
    const Services services{options.make_follower, options.make_trial, std::move(show),
                            job.traits().lane == Lane::edits ? follower : nullptr};
    return options.apply(base, job.command, context, services);
  }

  /// Called without the lock, on the work's thread.
  void show_evolving(CommandId id, const LabelVolume& liver) {
    auto shown = std::make_shared<const LabelVolume>(liver);
    std::unique_lock lock(mutex);
    put_evolving(id, std::move(shown));
    wake(lock);
  }
  void put_evolving(CommandId id, std::shared_ptr<const LabelVolume> liver) {
    evolving_of = id;
    amend([&](Snapshot& now) { now.evolving = std::move(liver); });
  }

  /// What a command that is done makes of what goes on live. Another case is not followed.
  void settle_live(const CommandTraits& traits, const Applied& applied) {
    if (traits.replaces_case()) stop_following();
    if (applied.live) applied.live(*this);
  }

  // LiveLanes; with the lock, on the edits' thread.
  void begin_tracking(std::shared_ptr<Follower> made) override {
    follower = std::move(made);
    set_tracking(true);
  }
  void end_tracking() override {
    follower.reset();
    stop_following();
  }
  void begin_trial(std::shared_ptr<LoadTrial> mechanics, const CaseState& made_from) override {
    trial.set_mechanics(std::move(mechanics));
    trial.begin(made_from);
    show_trial(std::make_shared<TrialState>());
  }
  void end_trial() override {
    trial.set_mechanics(nullptr);
    stop_trial();
  }

  void stop_trial() {
    trial.end();
    show_trial(nullptr);
  }
  void show_trial(std::shared_ptr<const TrialState> state) {
    amend([&](Snapshot& now) { now.trial = std::move(state); });
  }
  /// A step of the trial. Called with the lock held; lets go of it meanwhile.
  void step_trial(std::unique_lock<std::mutex>& lock) {
    if (auto state = trial.step(lock)) show_trial(std::move(state));
    finished.notify_all();
    wake(lock);
  }
  void stop_following() {
    set_tracking(false);
    frame.reset();
  }
  /// What followed the former case's organ goes, with its memory and its network. Its end may take a while.
  /// @return whether there was one: the lock was let go of meanwhile.
  bool let_go_of_former(std::unique_lock<std::mutex>& lock) {
    if (!follower || current->tracking) return false;
    auto former = std::exchange(follower, nullptr);
    lock.unlock();
    former.reset();
    lock.lock();
    return true;
  }
  void set_tracking(bool on) {
    live = {};
    amend([&](Snapshot& now) { now.tracking = on; });
  }

  void finish(std::unique_lock<std::mutex>& lock, Outcome outcome) {
    std::erase_if(events, [&](const Event& event) {
      const auto* progress = std::get_if<Progress>(&event);
      return progress != nullptr && progress->id == outcome.id;
    });
    events.emplace_back(outcome);
    outcomes.add(std::move(outcome));
    finished.notify_all();
    wake(lock);
  }

  /// Follows the newest frame. Called with the lock held; lets go of it meanwhile.
  void follow(std::unique_lock<std::mutex>& lock) {
    const LiveInput taken = std::move(*frame);
    frame.reset();
    following = true;
    lock.unlock();
    OverlayFrame overlay;
    std::vector<CorrectionMade> corrections;
    std::optional<MaskStatus> mask;
    std::shared_ptr<const LabelledCloud> tissue;
    std::visit(
        [&](const auto& input) {
          overlay.index = input.index;
          overlay.seconds = input.seconds;
        },
        taken);
    overlay.validity = Validity::mechanics_failed;
    try {
      if (follower) {
        overlay = follower->follow(taken);
        corrections = follower->corrections();
        mask = follower->mask_status();
        tissue = follower->tissue_at_start();
      }
    } catch (const std::exception&) {
      // Whatever went wrong, there is no overlay for this frame; the next one may do better.
      overlay.nodes_in_camera.resize(0, 3);
    }
    lock.lock();
    following = false;
    if (current->tracking) {
      if (stage_state(current->state, part::live) == StageState::stale) overlay.validity = Validity::stale;
      ++live.frames;
      live.frames_late += overlay.milliseconds > 1e3 * options.frame_seconds;
      live.overlay = std::move(overlay);
      live.corrections = std::move(corrections);
      live.mask = std::move(mask);
      live.tissue_at_start = std::move(tissue);
      if (const auto* pictures = std::get_if<StereoFrame>(&taken)) live.frame = *pictures;
      CaseState state = current->state;
      state[part::live] = std::make_shared<const LiveState>(live);
      publish(std::move(state), "frame");
    }
    finished.notify_all();
    wake(lock);
  }

  bool frame_ready() const { return frame.has_value() && current->tracking; }

  void serve_edits() {
    std::unique_lock lock(mutex);
    while (!stopping) {
      if (let_go_of_former(lock)) continue;
      if (const auto job = take_ready(Lane::edits)) {
        lock.unlock();
        run(job);
        lock.lock();
      } else {
        // Both live things have their turn.
        const bool followed = frame_ready(), stepped = trial.is_due();
        if (followed) follow(lock);
        if (stepped && trial.is_due()) step_trial(lock);
        if (!followed && !stepped) wait_for_change(lock);
      }
    }
  }

  void wait_for_change(std::unique_lock<std::mutex>& lock) {
    if (const auto next = trial.next())
      changed.wait_until(lock, *next);
    else
      changed.wait(lock);
  }

  void serve_work() {
    std::unique_lock lock(mutex);
    while (!stopping) {
      if (const auto job = take_ready(Lane::work)) {
        lock.unlock();
        run(job);
        lock.lock();
      } else {
        changed.wait(lock);
      }
    }
  }

  /// Inline: everything that waits, in order, on the caller's thread. A post from within a command waits its
  /// turn.
  void drain() {
    for (;;) {
      std::shared_ptr<Job> job;
      {
        std::unique_lock lock(mutex);
        let_go_of_former(lock);
        if (waiting.empty() || !running.empty()) return;
        job = waiting.front();
        waiting.pop_front();
        running.push_back(job);
      }
      run(job);
    }
  }
};

void Engine::Options::validate() const {
  require(frame_seconds > 0.0, "a frame takes some time");
  require(trial_seconds >= 0.0, "a trial's steps follow each other");
}

Engine::Engine(Options options) : impl_(std::make_unique<Impl>(std::move(options))) {
  impl_->options.validate();
  if (impl_->options.runner == Runner::inline_) return;
  impl_->edits_thread = std::jthread([this] { impl_->serve_edits(); });
  impl_->work_thread = std::jthread([this] { impl_->serve_work(); });
}

Engine::~Engine() {
  cancel_all();
  {
    const std::scoped_lock lock(impl_->mutex);
    impl_->stopping = true;
    impl_->options.wake = nullptr;
  }
  impl_->changed.notify_all();
  if (impl_->edits_thread.joinable()) impl_->edits_thread.join();
  if (impl_->work_thread.joinable()) impl_->work_thread.join();
}

CommandId Engine::post(Command command, std::optional<std::uint64_t> case_number) {
  const auto job =
      std::make_shared<Job>(Job{0, std::move(command), std::make_shared<CancelFlag>(), case_number});
  {
    const std::scoped_lock lock(impl_->mutex);
    job->id = impl_->next_id++;
    impl_->waiting.push_back(job);
  }
  if (impl_->options.runner == Runner::inline_)
    impl_->drain();
  else
    impl_->changed.notify_all();
  return job->id;
}

void Engine::cancel(CommandId id) {
  std::unique_lock lock(impl_->mutex);
  for (const auto& job : impl_->running)
    if (job->id == id) job->cancel->request();
  const auto waits = std::find_if(impl_->waiting.begin(), impl_->waiting.end(),
                                  [&](const auto& job) { return job->id == id; });
  if (waits == impl_->waiting.end()) return;
  Outcome outcome = Impl::outcome_of(**waits);
  outcome.status = Status::cancelled;
  impl_->waiting.erase(waits);
  impl_->finish(lock, std::move(outcome));
}

void Engine::cancel_all() {
  std::vector<CommandId> ids;
  {
    const std::scoped_lock lock(impl_->mutex);
    for (const auto& job : impl_->running) ids.push_back(job->id);
    for (const auto& job : impl_->waiting) ids.push_back(job->id);
  }
  for (const CommandId id : ids) cancel(id);
}

void Engine::submit_frame(LiveInput frame) {
  std::unique_lock lock(impl_->mutex);
  if (!impl_->current->tracking) return;
  impl_->live.frames_dropped += impl_->frame.has_value();
  impl_->frame = std::move(frame);
  if (impl_->options.runner == Runner::inline_)
    impl_->follow(lock);
  else
    impl_->changed.notify_all();
}

void Engine::submit_pull(std::optional<TrialPull> pull) {
  std::unique_lock lock(impl_->mutex);
  impl_->trial.submit(std::move(pull));
  if (!impl_->trial.is_on()) return;
  if (impl_->options.runner == Runner::inline_)
    impl_->step_trial(lock);
  else
    impl_->changed.notify_all();
}

std::shared_ptr<const Snapshot> Engine::snapshot() const {
  const std::scoped_lock lock(impl_->mutex);
  return impl_->current;
}

std::vector<Event> Engine::take_events() {
  const std::scoped_lock lock(impl_->mutex);
  impl_->wake_sent = false;
  std::vector<Event> taken(std::make_move_iterator(impl_->events.begin()),
                           std::make_move_iterator(impl_->events.end()));
  impl_->events.clear();
  return taken;
}

Outcome Engine::wait(CommandId id) {
  std::unique_lock lock(impl_->mutex);
  require(id > 0 && id < impl_->next_id, "wait needs the id of a posted command");
  const OutcomeStore::Wanted wanted(impl_->outcomes, id);
  impl_->finished.wait(lock, [&] { return impl_->outcomes.find(id) != nullptr; });
  return *impl_->outcomes.find(id);
}

void Engine::wait_for_frames() {
  std::unique_lock lock(impl_->mutex);
  impl_->finished.wait(lock, [&] { return !impl_->frame_ready() && !impl_->following; });
}

void Engine::wait_for_trial() {
  std::unique_lock lock(impl_->mutex);
  impl_->finished.wait(lock, [&] { return !impl_->trial.is_behind(); });
}

}  // namespace glisson::engine
