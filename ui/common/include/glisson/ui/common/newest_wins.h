// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace glisson::ui {

/// A thread that works at the newest of the orders that it was given: those that came in between are
/// dropped, so that it never falls behind.
template <class Order>
class NewestWins {
 public:
  /// @param stop of this order: it is cancelled, or this object goes.
  using Work = std::function<void(const Order& order, const std::stop_token& stop)>;
  /// @param work runs on the thread. What it touches must outlive this.
  explicit NewestWins(Work work)
      : work_(std::move(work)), thread_([this](const std::stop_token& stop) { run(stop); }) {}
  ~NewestWins() {
    thread_.request_stop();
    cancel();
    thread_.join();
  }
  NewestWins(const NewestWins&) = delete;
  NewestWins& operator=(const NewestWins&) = delete;

  /// The order at work, if there is one, is finished first.
  void give(Order order) {
    {
      const std::lock_guard lock(mutex_);
      order_ = std::move(order);
    }
    wake_.notify_one();
  }
  /// Nothing is wanted any more: what waits is dropped, and what is at work is asked to stop.
  void cancel() {
    const std::lock_guard lock(mutex_);
    order_.reset();
    at_work_.request_stop();
  }

 private:
  void run(const std::stop_token& stop) {
    while (true) {
      std::optional<Order> order;
      std::stop_token cancelled;
      {
        std::unique_lock lock(mutex_);
        wake_.wait(lock, stop, [this] { return order_.has_value(); });
        if (stop.stop_requested()) return;
        std::swap(order, order_);
        at_work_ = std::stop_source();
        cancelled = at_work_.get_token();
      }
      work_(*order, cancelled);
    }
  }

  Work work_;
  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::optional<Order> order_;
  std::stop_source at_work_;
  std::jthread thread_;  ///< last: it uses the others
};

}  // namespace glisson::ui
