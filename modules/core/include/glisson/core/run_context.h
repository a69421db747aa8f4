// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <string_view>

namespace glisson {

/// What an algorithm returns that can be cancelled: empty means that its RunContext was cancelled. Cancel is
/// a status, not an error; errors are thrown.
template <class T>
using Cancellable = std::optional<T>;

/// One bit, set once, from any thread. Shared by who asks and who computes; it belongs to its command from
/// the moment of submission, so a request that comes before the work starts is not lost.
class CancelFlag {
 public:
  void request() { requested_.store(true, std::memory_order_relaxed); }
  bool requested() const { return requested_.load(std::memory_order_relaxed); }

 private:
  std::atomic<bool> requested_{false};
};

/// All that an algorithm sees of the outside: how far it is, whether to stop, and where its random numbers
/// come from. Cheap to copy; safe to read from several threads, progress() from one at a time.
class RunContext {
 public:
  /// Receives the fraction done in [0, 1] and the code of the stage (English, dotted: "mesh.refine"; the
  /// window translates codes, modules hold no strings for people).
  using ProgressSink = std::function<void(double fraction, std::string_view stage)>;

  /// Nothing listens, nothing cancels, seed 1.
  RunContext();
  RunContext(ProgressSink sink, std::shared_ptr<const CancelFlag> cancel, std::uint64_t seed);

  bool cancelled() const { return cancel_ && cancel_->requested(); }
  void progress(double fraction, std::string_view stage) const;
  std::uint64_t seed() const { return seed_; }

  /// A generator for one named purpose: the same (seed, purpose) always gives the same numbers, different
  /// purposes independent ones.
  std::mt19937_64 random(std::string_view purpose) const;

  /// A context whose progress [0, 1] is mapped onto [from, to] of this one's.
  RunContext part(double from, double to) const;
  /// The same cancel and seed, and nobody listens: for a piece of work whose progress its caller counts, and
  /// for threads beside the one that reports.
  RunContext quiet() const;

 private:
  ProgressSink sink_;
  std::shared_ptr<const CancelFlag> cancel_;
  std::uint64_t seed_ = 1;
  double from_ = 0.0, to_ = 1.0;
};

}  // namespace glisson
