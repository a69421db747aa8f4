// SPDX-License-Identifier: GPL-3.0-or-later
#include "fresh_noise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace glisson::guidance {
namespace {

constexpr int kStep = 4;                        ///< pixels between the places that are looked at
constexpr int kDarkest = 12, kBrightest = 240;  ///< beyond them noise is cut off
constexpr int kSkipped = std::numeric_limits<int>::min();
constexpr std::size_t kLeastPlaces = 200;
constexpr double kSeconds = 0.3;  ///< shorter than what says that a picture stands, so all of it stands
constexpr double kForget = 2.0;   ///< seconds in which what is usual is learned anew
/// Of a normal distribution's deviation; what the mask makes of one pixel's noise.
constexpr double kQuartile = 0.3186, kGain = 6.0;

/// Lower quartile of absolute values, each a whole number that stands for what rounds to it.
class Quartile {
 public:
  void add(int value) {
    ++count_[static_cast<std::size_t>(std::min(std::abs(value), static_cast<int>(count_.size()) - 1))];
    ++all_;
  }
  std::size_t all() const { return all_; }
  double value() const {
    double below = 0.0;
    const double wanted = 0.25 * static_cast<double>(all_);
    for (std::size_t v = 0; v < count_.size(); ++v) {
      const double here = count_[v], wide = v == 0 ? 0.5 : 1.0;
      if (below + here >= wanted && here > 0.0)
        return static_cast<double>(v) - (v == 0 ? 0.0 : 0.5) + wide * (wanted - below) / here;
      below += here;
    }
    return static_cast<double>(count_.size());
  }

 private:
  std::array<int, 512> count_{};
  std::size_t all_ = 0;
};

}  // namespace

void FreshNoise::look(const Picture& picture, View& view) {
  const std::vector<int> before = std::move(view.masked);
  view.masked.clear();
  Quartile now, change;
  const int channel = picture.channels == 3 ? 1 : 0, across = picture.width * picture.channels;
  for (int y = 1; y + 1 < picture.height; y += kStep)
    for (int x = 1; x + 1 < picture.width; x += kStep) {
      const std::uint8_t* p = picture.bytes->data() + static_cast<std::ptrdiff_t>(y) * across +
                              static_cast<std::ptrdiff_t>(x) * picture.channels + channel;
      const auto at = [&](int right, int down) -> int { return p[right * picture.channels + down * across]; };
      int masked = kSkipped;
      if (at(0, 0) > kDarkest && at(0, 0) < kBrightest)
        masked = at(-1, -1) + at(1, -1) + at(-1, 1) + at(1, 1) + 4 * at(0, 0) -
                 2 * (at(0, -1) + at(-1, 0) + at(1, 0) + at(0, 1));
      const std::size_t i = view.masked.size();
      view.masked.push_back(masked);
      if (masked == kSkipped || (i < before.size() && before[i] == kSkipped)) continue;
      now.add(masked);
      if (i < before.size()) change.add(masked - before[i]);
    }
  view.fresh = -1.0;
  if (now.all() < kLeastPlaces) return;
  view.noise = now.value() / (kQuartile * kGain);
  if (before.size() == view.masked.size())
    view.fresh = 0.5 * std::pow(change.value() / std::max(now.value(), 0.5), 2);
}

void FreshNoise::push(const StereoFrame& frame, const FrameClock& clock) {
  look(frame.left, left_);
  look(frame.right, right_);
  noise_ = std::max(left_.noise, right_.noise);
  passed_ = clock.passed();
  freshest_.emplace_back(clock.now(), std::min(left_.fresh, right_.fresh));
  while (freshest_.front().first < clock.now() - kSeconds) freshest_.pop_front();
}

void FreshNoise::learn() {
  const double share = std::min(1.0, passed_ / kForget);
  usual_ = usual_ > 0.0 ? (1.0 - share) * usual_ + share * noise_ : noise_;
}

double FreshNoise::fresh() const {
  double most = -1.0;
  for (const auto& [seconds, fresh] : freshest_) most = std::max(most, fresh);
  return most;
}

}  // namespace glisson::guidance
