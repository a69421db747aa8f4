// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>

#include "glisson/core/run_context.h"
#include "glisson/ui/common/newest_wins.h"

namespace glisson::ui {

/// Previews that take longer than a frame: computed on a thread of their own, on which the newest order wins,
/// and handed over in the window's thread. What is cancelled is never handed over.
template <class Order, class Result>
class PreviewService {
 public:
  /// On the thread. Empty: cancelled. Must not throw.
  using Compute = std::function<Cancellable<Result>(const Order& order, const RunContext& context)>;
  /// In the owner's thread. Orders that came in between may have won by then: whoever is asked decides.
  using Accept = std::function<void(const Order& order, const std::shared_ptr<const Result>& result)>;

  /// @param owner has this as a member, and is what `accept` touches.
  PreviewService(QObject* owner, Compute compute, Accept accept)
      : owner_(owner),
        compute_(std::move(compute)),
        accept_(std::move(accept)),
        computing_([this](const Numbered& order, const std::stop_token& stop) { run(order, stop); }) {}

  /// What is being computed is finished and handed over first: under a moving hand something is always seen.
  void give(Order order) { computing_.give({std::move(order), round_}); }
  /// What is being computed is given up: it would be out of date.
  void give_instead(Order order) {
    cancel();
    give(std::move(order));
  }
  void cancel() {
    ++round_;
    computing_.cancel();
  }

 private:
  struct Numbered {
    Order order;
    std::uint64_t round = 0;  ///< how often cancel() had been called
  };

  void run(const Numbered& numbered, const std::stop_token& stop) {
    const auto flag = std::make_shared<CancelFlag>();
    const std::stop_callback ask(stop, [&flag] { flag->request(); });
    auto result = compute_(numbered.order, RunContext({}, flag, 1));
    if (!result || flag->requested()) return;
    QMetaObject::invokeMethod(
        owner_,
        [this, numbered, made = std::make_shared<const Result>(std::move(*result))] {
          if (numbered.round == round_) accept_(numbered.order, made);
        },
        Qt::QueuedConnection);
  }

  QObject* owner_;
  Compute compute_;
  Accept accept_;
  std::uint64_t round_ = 0;         ///< the window's thread's
  NewestWins<Numbered> computing_;  ///< last: its thread uses the others
};

}  // namespace glisson::ui
