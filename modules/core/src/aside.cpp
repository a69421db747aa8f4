// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/core/aside.h"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <utility>

namespace glisson {

/// Where calls are handed over. Of both: the thread may outlast who asks.
struct Aside::Desk {
  std::mutex mutex;
  std::condition_variable changed;
  std::function<void()> call;  // that waits to be done; empty: none
  bool is_done = true, is_closed = false;
  std::exception_ptr failure;
};

Aside::Aside() : desk_(std::make_shared<Desk>()), thread_([desk = desk_] { serve(desk); }) {}

Aside::~Aside() {
  bool is_done = false;
  {
    const std::scoped_lock lock(desk_->mutex);
    desk_->is_closed = true;
    is_done = desk_->is_done;
  }
  desk_->changed.notify_all();
  if (is_done)
    thread_.join();
  else
    thread_.detach();
}

void Aside::serve(const std::shared_ptr<Desk>& desk) {
  std::unique_lock lock(desk->mutex);
  for (;;) {
    desk->changed.wait(lock, [&] { return desk->is_closed || desk->call; });
    if (desk->is_closed) return;
    std::function<void()> call = std::exchange(desk->call, nullptr);
    lock.unlock();
    std::exception_ptr failure;
    try {
      call();
    } catch (...) {
      failure = std::current_exception();
    }
    call = nullptr;  // what it holds goes before the one who waits goes on
    lock.lock();
    desk->failure = failure;
    desk->is_done = true;
    desk->changed.notify_all();
  }
}

bool Aside::run(std::function<void()> call, const RunContext& context) {
  constexpr auto kLook = std::chrono::milliseconds(50);
  std::unique_lock lock(desk_->mutex);
  if (desk_->is_closed) return false;
  desk_->call = std::move(call);
  desk_->is_done = false;
  desk_->changed.notify_all();
  while (!desk_->is_done) {
    if (context.cancelled()) {
      desk_->is_closed = true;
      desk_->changed.notify_all();
      return false;
    }
    desk_->changed.wait_for(lock, kLook);
  }
  if (desk_->failure) std::rethrow_exception(std::exchange(desk_->failure, nullptr));
  return true;
}

}  // namespace glisson
