// SPDX-License-Identifier: GPL-3.0-or-later
#include "seen_shares.h"

#include <algorithm>

namespace glisson::guidance {
namespace {

/// Rays: then a part's share is known to a sixth and is left so, lest smoke that comes slowly be learnt.
constexpr int kEnough = 10;
constexpr double kLeastExpected = 20.0;  ///< places: of fewer a third can be missing by chance

}  // namespace

void SeenShares::learn(const std::vector<ClosestPoint>& hits, const std::vector<char>& is_seen) {
  std::vector<Part> now(parts_.size());
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (hits[i].triangle < 0) continue;
    Part& part = now[static_cast<std::size_t>(hits[i].triangle)];
    ++part.looks;
    part.seen += is_seen[i] != 0;
  }
  for (std::size_t t = 0; t < parts_.size(); ++t) {
    if (parts_[t].looks >= kEnough) continue;
    parts_[t].looks += now[t].looks;
    parts_[t].seen += now[t].seen;
  }
}

double SeenShares::missing(const std::vector<ClosestPoint>& hits, const std::vector<char>& is_seen) const {
  double expected = 0.0, seen = 0.0;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (hits[i].triangle < 0) continue;
    const Part& part = parts_[static_cast<std::size_t>(hits[i].triangle)];
    if (part.looks == 0) continue;
    expected += part.seen / static_cast<double>(part.looks);
    seen += is_seen[i] != 0;
  }
  return expected < kLeastExpected ? 0.0 : std::clamp(1.0 - seen / expected, 0.0, 1.0);
}

}  // namespace glisson::guidance
