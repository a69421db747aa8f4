// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/openigtlink/sender.h"

#include <poll.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <list>
#include <mutex>
#include <thread>
#include <utility>

#include "bulletin.h"
#include "clock.h"
#include "glisson/core/error.h"
#include "peer.h"
#include "socket.h"

namespace glisson::openigtlink {
namespace {

double seconds_since_1970() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

/// What somebody has said last.
struct Said {
  std::shared_ptr<const SentModel> model;
  OverlayFrame frame;
  Clock::time_point at = Clock::now();  ///< when the frame was said first
};

bool is_same_frame(const OverlayFrame& a, const OverlayFrame& b) {
  return a.index == b.index && a.seconds == b.seconds;
}

}  // namespace

void SenderOptions::validate() const {
  const OptionCheck demand("sender options");
  demand(surfaces_per_second > 0.0 && surfaces_per_second <= 100.0, "surfaces_per_second",
         surfaces_per_second, "Give up to 100");
  demand(silence > 0.0 && silence <= 60.0, "silence", silence, "Give up to 60 seconds");
  demand(patience > 0.0 && patience <= 60.0, "patience", patience, "Give up to 60 seconds");
  demand(most_peers > 0 && most_peers <= 64, "most_peers", most_peers, "Give a number from 1 to 64");
}

struct Sender::Impl {
  explicit Impl(const SenderOptions& given)
      : options(given), listener(listen_at(given.address)), bulletin(given.surfaces_per_second) {}

  SenderOptions options;
  Descriptor listener;
  Bell bell;

  mutable std::mutex mutex;  // guards the next two
  std::optional<Said> newest;
  SenderState state;

  // Of the thread only.
  Bulletin bulletin;
  Said said;
  std::list<Peer> peers;
  std::optional<double> epoch;
  bool is_composed = false;  ///< the bulletin is of `said`
  std::jthread thread;       // last: it ends before what it uses

  void serve(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      wait();
      take_newest();
      admit();
      tell_peers();
    }
    farewell();
  }

  /// Until something comes, goes, or is due.
  void wait() {
    constexpr int kTick = 50;  // milliseconds, for silence and patience
    std::vector<pollfd> watched = {{bell.number(), POLLIN, 0}, {listener.number(), POLLIN, 0}};
    for (const Peer& peer : peers)
      watched.push_back(
          {peer.number(), static_cast<short>(peer.is_waiting() ? POLLIN | POLLOUT : POLLIN), 0});
    ::poll(watched.data(), watched.size(), kTick);
    bell.quiet();
  }

  void take_newest() {
    std::optional<Said> taken;
    {
      const std::scoped_lock lock(mutex);
      taken.swap(newest);
    }
    if (taken) {
      const bool begins_anew = taken->frame.seconds < said.frame.seconds;
      // Told again, as when it is corrected or when the case changes, a frame is no younger.
      if (!taken->model || (epoch && is_same_frame(taken->frame, said.frame))) taken->at = said.at;
      if (!taken->model) taken->frame = withdrawn(taken->frame.validity);
      if (taken->model && (!epoch || begins_anew))
        epoch = options.epoch ? *options.epoch : seconds_since_1970() - taken->frame.seconds;
      said = std::move(*taken);
      is_composed = false;
    }
    if (said.frame.level() != Level::withdrawn && seconds_since(said.at) > options.silence) {
      said.frame = withdrawn(Validity::stale);
      is_composed = false;
    }
  }

  /// The last frame without anything that could be shown.
  OverlayFrame withdrawn(Validity reason) const {
    OverlayFrame frame;
    frame.index = said.frame.index;
    frame.seconds = said.frame.seconds;
    frame.doubtful = said.frame.doubtful;
    frame.validity = reason;
    return frame;
  }

  void admit() {
    for (Descriptor peer = accept_peer(listener); peer.is_open(); peer = accept_peer(listener))
      if (peers.size() < static_cast<std::size_t>(options.most_peers)) peers.emplace_back(std::move(peer));
    // One too many is closed here.
  }

  void tell_peers() {
    if (!peers.empty() && !is_composed) {
      bulletin.compose(said.model.get(), said.frame, epoch.value_or(0.0));
      is_composed = true;
      const std::scoped_lock lock(mutex);
      ++state.frames;
    }
    int given_up = 0;
    for (auto peer = peers.begin(); peer != peers.end();) {
      bool stays = peer->hear() && peer->flush();
      if (stays && peer->tell(bulletin)) stays = peer->flush();
      const bool is_stuck = stays && peer->stuck() > options.patience;
      given_up += is_stuck;
      peer = stays && !is_stuck ? std::next(peer) : peers.erase(peer);
    }
    const std::scoped_lock lock(mutex);
    state.peers = static_cast<int>(peers.size());
    state.given_up += given_up;
  }

  /// Nobody goes on showing what is not followed any more.
  void farewell() {
    constexpr double kLongest = 0.1;
    take_newest();
    if (said.frame.level() != Level::withdrawn) said.frame = withdrawn(Validity::not_started);
    is_composed = false;
    const Clock::time_point begin = Clock::now();
    do {
      tell_peers();
      std::vector<pollfd> watched;
      for (const Peer& peer : peers)
        if (peer.is_waiting()) watched.push_back({peer.number(), POLLOUT, 0});
      if (watched.empty()) break;
      ::poll(watched.data(), watched.size(), 10);
    } while (seconds_since(begin) < kLongest);
  }

  void say(Said what) {
    {
      const std::scoped_lock lock(mutex);
      newest = std::move(what);
    }
    bell.ring();
  }
};

Sender::Sender(const SenderOptions& options) {
  options.validate();
  impl_ = std::make_unique<Impl>(options);
  impl_->thread = std::jthread([impl = impl_.get()](const std::stop_token& stop) { impl->serve(stop); });
}

Sender::~Sender() {
  impl_->thread.request_stop();
  impl_->bell.ring();
}

Address Sender::address() const { return {impl_->options.address.host, port_of(impl_->listener)}; }

void Sender::tell(std::shared_ptr<const SentModel> model, OverlayFrame frame) {
  require(model != nullptr && model->model != nullptr, "a frame is told of a model");
  impl_->say({std::move(model), std::move(frame)});
}

void Sender::withdraw(Validity reason) {
  require(level_of(reason) == Level::withdrawn, "what is withdrawn has a reason of that level");
  Said said;
  said.frame.validity = reason;
  impl_->say(std::move(said));
}

SenderState Sender::state() const {
  const std::scoped_lock lock(impl_->mutex);
  return impl_->state;
}

}  // namespace glisson::openigtlink
