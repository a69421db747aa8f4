// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "glisson/core/json_file.h"
#include "glisson/core/run_context.h"
#include "glisson/engine/case_state.h"
#include "glisson/engine/command.h"
#include "glisson/engine/live.h"
#include "glisson/engine/load_trial.h"

namespace glisson::engine {

using CommandId = std::uint64_t;

/// Does a command that nothing stands in the way of. @throws InputError the obstacle.
using Apply =
    std::function<Cancellable<Applied>(const CaseState&, const Command&, const RunContext&, const Services&)>;
Cancellable<Applied> apply(const CaseState& state, const Command& command, const RunContext& context,
                           const Services& services = plain_services());

enum class Status { done, cancelled, failed };

/// How a command ended. Every posted command has exactly one outcome.
struct Outcome {
  CommandId id = 0;
  std::string command;  ///< its code
  Status status = Status::done;
  std::string error;  ///< one sentence with the remedy, when failed
  Figures figures;
  std::vector<std::string> notes;
  Result result = {};  ///< of a command that has one
  /// Of the command, with its parts and how far it concerns the person.
  CommandTraits traits = {};
  double seconds = 0.0;
};
/// How far a running command has come. Of each command only the newest is kept until it is taken.
struct Progress {
  CommandId id = 0;
  std::string command;
  double fraction = 0.0;  ///< of the whole command, 0 to 1
  std::string stage;      ///< code
};
using Event = std::variant<Progress, Outcome>;

/// The case at one moment. Immutable; may be kept and read from any thread.
struct Snapshot {
  std::uint64_t revision = 0;
  std::uint64_t case_number = 0;  ///< how many cases there have been before this one
  std::string cause;              ///< code of the command that led to it; "frame" for the live lane
  CaseState state;
  std::map<Part, StageState> stages;  ///< of every part that is not absent
  StageState stage(Part part) const {
    const auto known = stages.find(part);
    return known == stages.end() ? StageState::absent : known->second;
  }
  bool tracking = false;
  /// Of the load trial that is on, or that has ended by itself; null: none. Not a part of the case, and no
  /// reason for another revision.
  std::shared_ptr<const TrialState> trial;
  /// The liver as its contour stands while `segment` runs, 0 or 1 on the image's grid; null otherwise.
  std::shared_ptr<const LabelVolume> evolving;
};

enum class Runner { inline_, threaded };

/// The only writer of the case. With the threaded runner commands are done on threads of its own: edits and
/// live frames on one, long work on another; with the inline runner inside post() and submit_frame(). Both
/// pass the same tests. post, cancel, submit_frame, snapshot, take_events may be called from any thread.
class Engine {
 public:
  /// How commands are run, and what stands in for the modules in tests.
  struct Options {
    Runner runner = Runner::threaded;
    std::uint64_t seed = 1;
    /// Stands in for the modules. Commands about what goes on live are made of the next two instead.
    Apply apply = engine::apply;
    MakeFollower make_follower = engine::make_follower;
    MakeTrial make_trial = engine::make_load_trial;
    /// Called from the engine's threads when a snapshot or an event is new; must return at once and not call
    /// back.
    std::function<void()> wake;
    /// Inline runner: progress as it happens (events come only after the command).
    std::function<void(const Progress&)> progress;
    double frame_seconds = 1.0 / 30.0;  ///< a frame that takes longer counts as late
    double trial_seconds = 1.0 / 60.0;  ///< from one step of a load trial to the next, at least
    /// @throws PreconditionError unless a frame's time is positive and the trial's not negative.
    void validate() const;
  };
  /// @throws PreconditionError as Options::validate().
  explicit Engine(Options options);
  /// Cancels what is running, drops what waits, joins its threads.
  ~Engine();
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  /// Takes a command in; how it ends is told by its Outcome alone. Threaded: returns at once, and the command
  /// runs on one of the engine's threads. Inline: runs it, and all that waits before it, on the caller's
  /// thread before it returns; a post from within a command waits its turn.
  ///
  /// What a person did to the case that is on screen names it by its snapshot's `case_number`: where another
  /// case has taken its place before the command begins, it ends as cancelled. A command that itself puts
  /// another case in place (CommandTraits::replaces_case) is done all the same.
  /// @return the command's id, from 1 upwards.
  CommandId post(Command command, std::optional<std::uint64_t> case_number = {});
  /// Never lost: a command that waits ends as cancelled without starting; one that runs is told. Unknown or
  /// finished ids are ignored.
  void cancel(CommandId id);
  void cancel_all();

  /// Newest wins: an unfollowed older frame is dropped and counted. Ignored unless tracking.
  void submit_frame(LiveInput frame);

  /// Pulls at the model of the load trial that is on, from now until the next one (empty: lets go). Newest
  /// wins, there is no queue. Ignored unless a trial is on. With the threaded runner steps go on by
  /// themselves at the trial's pace until the organ rests; with the inline runner each call is one step.
  /// @throws PreconditionError for a pull that is not at the model's surface or not finite; the former stays.
  void submit_pull(std::optional<TrialPull> pull);

  /// Never null.
  std::shared_ptr<const Snapshot> snapshot() const;
  /// Everything since the last call, in order. Outcomes are never dropped; of a command's progress only the
  /// newest that was not taken is kept.
  std::vector<Event> take_events();

  /// Waits for a command's end; for command lines and tests, never for a window. @pre `id` came from post().
  Outcome wait(CommandId id);
  /// Waits until the submitted frame, if any, has been followed.
  void wait_for_frames();
  /// Waits until the submitted pull, if any, is in a published step.
  void wait_for_trial();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace glisson::engine
