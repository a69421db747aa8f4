// SPDX-License-Identifier: GPL-3.0-or-later
#include "peer.h"

#include <array>

namespace glisson::openigtlink {

bool Peer::wants(const Bulletin& bulletin) const {
  return outbox_.empty() && (level_ != bulletin.level_number() || surfaces_ != bulletin.surfaces_number());
}

bool Peer::tell(const Bulletin& bulletin) {
  if (!wants(bulletin)) return false;
  moved_ = Clock::now();
  if (level_ != bulletin.level_number()) outbox_.push_back(bulletin.level());
  if (surfaces_ != bulletin.surfaces_number()) outbox_.push_back(bulletin.surfaces());
  level_ = bulletin.level_number();
  surfaces_ = bulletin.surfaces_number();
  return true;
}

bool Peer::flush() {
  while (!outbox_.empty()) {
    const std::string& first = *outbox_.front();
    if (sent_ < first.size()) {
      const Passed passed = send_some(socket_, first.data() + sent_, first.size() - sent_);
      if (passed.gone) return false;
      if (passed.bytes == 0) return true;
      sent_ += passed.bytes;
      moved_ = Clock::now();
    }
    if (sent_ < first.size()) continue;
    outbox_.pop_front();
    sent_ = 0;
  }
  return true;
}

bool Peer::hear() {
  constexpr int kMostAtOnce = 16;  // one that talks without end must not keep the others waiting
  std::array<char, 4096> forgotten;
  for (int i = 0; i < kMostAtOnce; ++i) {
    const Passed passed = receive_some(socket_, forgotten.data(), forgotten.size());
    if (passed.gone) return false;
    if (passed.bytes == 0) break;
  }
  return true;
}

double Peer::stuck() const {
  if (outbox_.empty()) return 0.0;
  return seconds_since(moved_);
}

}  // namespace glisson::openigtlink
