// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/network/live_mask.h"

#include <algorithm>
#include <utility>

#include "glisson/core/error.h"
#include "mask_network.h"

namespace glisson::network {

LiveMask::LiveMask(std::filesystem::path network, int threads) : network_(std::move(network)) {
  const int all = static_cast<int>(std::thread::hardware_concurrency());
  const int given = threads > 0 ? threads : std::max(1, all / 4);
  thread_ = std::jthread([this, given](const std::stop_token& stop) { run(stop, given); });
}

LiveMask::~LiveMask() {
  thread_.request_stop();
  thread_.join();
}

void LiveMask::offer(const StereoFrame& frame) {
  if (frame.left.empty()) return;
  {
    const std::lock_guard lock(mutex_);
    if (failure_) return;
    waiting_ = frame;
  }
  changed_.notify_all();
}

void LiveMask::wait() const {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return (!waiting_ && !is_busy_) || failure_; });
}

std::shared_ptr<const PictureMask> LiveMask::usable(double now) const {
  const std::lock_guard lock(mutex_);
  if (!latest_) return nullptr;
  const double age = now - latest_->seconds;
  return age >= 0.0 && age <= oldest_seconds_ ? latest_ : nullptr;
}

std::optional<double> LiveMask::age(double now) const {
  const std::lock_guard lock(mutex_);
  return latest_ ? std::optional(now - latest_->seconds) : std::nullopt;
}

std::string LiveMask::problem() const {
  try {
    require_well();
  } catch (const std::exception& failure) {
    return failure.what();
  }
  return {};
}

void LiveMask::require_well() const {
  const std::lock_guard lock(mutex_);
  if (failure_) std::rethrow_exception(failure_);
}

void LiveMask::run(const std::stop_token& stop, int threads) {
  const auto cancel = std::make_shared<CancelFlag>();
  const std::stop_callback ask(stop, [cancel] { cancel->request(); });
  const RunContext context({}, cancel, 1);
  try {
    const std::unique_ptr<MaskNetwork> network = MaskNetwork::open(network_, context, threads);
    if (!network) return;
    std::unique_lock lock(mutex_);
    oldest_seconds_ = network->sheet().oldest_seconds;
    while (changed_.wait(lock, stop, [this] { return waiting_.has_value(); })) {
      const StereoFrame frame = *std::exchange(waiting_, std::nullopt);
      is_busy_ = true;
      lock.unlock();
      const Cancellable<Picture> mask = network->not_liver(frame.left, context);
      lock.lock();
      is_busy_ = false;
      if (!mask) return;
      latest_ = std::make_shared<const PictureMask>(PictureMask{*mask, frame.index, frame.seconds});
      changed_.notify_all();
    }
  } catch (...) {
    {
      const std::lock_guard lock(mutex_);
      failure_ = std::current_exception();
      latest_.reset();
      waiting_.reset();
      is_busy_ = false;
    }
    changed_.notify_all();
  }
}

}  // namespace glisson::network
