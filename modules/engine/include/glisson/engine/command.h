// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <any>
#include <concepts>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <typeinfo>
#include <utility>
#include <vector>

#include "glisson/core/json_file.h"
#include "glisson/core/run_context.h"
#include "glisson/engine/live.h"
#include "glisson/engine/part.h"

/// @file
/// A command describes itself: what it is called, what it reads and writes, what it needs, where it is done,
/// and what it does. The window, the command line and the tests post the same. A new command is one file
/// below commands/. An open set, not a std::variant: a closed list would be edited for each command, and
/// every unit that includes it compiled again.

namespace glisson::engine {

/// The engine's two threads: short edits (and everything live) on the one, long work on the other.
enum class Lane { edits, work };
/// What goes on live that a command starts or stops. Such commands keep their order among themselves; where
/// one fails, what goes on goes on.
enum class LiveLane { none, tracking, trial };
/// How far the end of a command concerns the person. `quiet`: a small edit, it passes too quickly to be
/// announced. `files`: it reads or writes what the person has just named, so that its failure must reach
/// that person. `unasked`: done ahead, for nobody as yet; it is shown while it goes on, and how it ends
/// concerns nobody.
enum class Notice { quiet, ordinary, files, unasked };

/// What the engine has to know of a command. Two commands may overlap or overtake each other only where
/// neither writes what the other touches; so the outcome is always that of the order in which they were
/// posted.
struct CommandTraits {
  std::string_view code;  ///< for progress, figures and logs: "segment", "build_model", ...
  Parts reads = {}, writes = {};
  Needs needs = {};     ///< cannot be done without them; what to see to first comes first
  Parts current = {};   ///< must not be out of date where they are there
  Parts accepted = {};  ///< must not stand refused
  Lane lane = Lane::work;
  Notice notice = Notice::ordinary;
  LiveLane live = LiveLane::none;

  /// Whether it puts another case in place of this one.
  bool replaces_case() const { return writes == Parts::all(); }
};

/// What a command tells besides figures and notes, of a type of its own (C::Result); empty: nothing.
class Result {
 public:
  Result() = default;
  template <class R>
  Result(std::shared_ptr<const R> value) : value_(std::move(value)) {}  // NOLINT: reads as an assignment
  /// Null: there is none, or it is of another type.
  template <class R>
  std::shared_ptr<const R> as() const {
    const auto* value = std::any_cast<std::shared_ptr<const R>>(&value_);
    return value == nullptr ? nullptr : *value;
  }

 private:
  std::any value_;
};

/// What a command made of a state.
struct Applied {
  CaseState state;
  Figures figures = {};                 ///< flat, units in the names
  std::vector<std::string> notes = {};  ///< codes with values, for people to be told
  Result result = {};
  /// What becomes of the live lanes when this is committed; empty: nothing. On the edits' thread.
  std::function<void(LiveLanes&)> live = {};
  /// The state brings its own stamps (a case that was opened).
  bool keeps_stamps = false;
  /// What it did outside of the case stands: who cancels it now comes too late.
  bool is_final = false;
};

namespace detail {
template <class C>
concept AppliesWithServices = requires(const C& c, const CaseState& state, const RunContext& context,
                                       const Services& services) {
  { c.apply(state, context, services) } -> std::same_as<Cancellable<Applied>>;
};
template <class C>
concept AppliesAlone = requires(const C& c, const CaseState& state, const RunContext& context) {
  { c.apply(state, context) } -> std::same_as<Cancellable<Applied>>;
};
}  // namespace detail

/// A value that says its traits and does itself: pure but for files, reads the state, never changes it.
/// Empty: cancelled. Throws Error.
template <class C>
concept CommandType = requires(const C& c) {
  { c.traits() } -> std::same_as<CommandTraits>;
}
&&(detail::AppliesAlone<C> || detail::AppliesWithServices<C>);

/// Any command, as a value.
class Command {
 public:
  template <class C>
  requires CommandType<std::remove_cvref_t<C>> Command(C&& command)  // NOLINT: every command is one
      : held_(std::make_shared<const Held<std::remove_cvref_t<C>>>(std::forward<C>(command))) {}

  const CommandTraits& traits() const { return held_->traits; }
  std::string_view code() const { return held_->traits.code; }
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context,
                             const Services& services) const {
    return held_->apply(state, context, services);
  }
  /// The command itself; null: it is another. For tests and stand-ins: nothing in the engine or the window
  /// asks which command it is.
  template <class C>
  const C* as() const {
    const auto* held = dynamic_cast<const Held<C>*>(held_.get());
    return held == nullptr ? nullptr : &held->command;
  }

 private:
  struct AnyHeld {
    explicit AnyHeld(CommandTraits its) : traits(std::move(its)) {}
    virtual ~AnyHeld() = default;
    virtual Cancellable<Applied> apply(const CaseState& state, const RunContext& context,
                                       const Services& services) const = 0;
    CommandTraits traits;
  };
  template <class C>
  struct Held final : AnyHeld {
    explicit Held(C its) : AnyHeld(its.traits()), command(std::move(its)) {}
    Cancellable<Applied> apply(const CaseState& state, const RunContext& context,
                               const Services& services) const override {
      if constexpr (detail::AppliesWithServices<C>)
        return command.apply(state, context, services);
      else
        return command.apply(state, context);
    }
    C command;
  };

  std::shared_ptr<const AnyHeld> held_;
};

}  // namespace glisson::engine
