// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <string>

#include "bulletin.h"
#include "clock.h"
#include "socket.h"

namespace glisson::openigtlink {

/// One that has connected. What it is told is always the newest: while it has not taken the last, nothing
/// more is put on its way.
class Peer {
 public:
  explicit Peer(Descriptor socket) : socket_(std::move(socket)) {}

  int number() const { return socket_.number(); }
  bool is_waiting() const { return !outbox_.empty(); }
  /// Whether it would be put something on its way now.
  bool wants(const Bulletin& bulletin) const;
  /// Puts on its way what of the bulletin it does not know yet. @return whether that was anything.
  bool tell(const Bulletin& bulletin);
  /// Sends what goes. @return false: it is gone.
  bool flush();
  /// What peers say is not asked for: taken and forgotten. @return false: it is gone.
  bool hear();
  /// For how long it has taken nothing of what waits, seconds.
  double stuck() const;

 private:
  Descriptor socket_;
  std::deque<Bytes> outbox_;
  std::size_t sent_ = 0;  ///< of the first
  std::uint64_t level_ = 0, surfaces_ = 0;
  Clock::time_point moved_ = Clock::now();
};

}  // namespace glisson::openigtlink
