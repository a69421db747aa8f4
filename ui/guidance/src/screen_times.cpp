// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/screen_times.h"

#include <algorithm>
#include <cstdio>
#include <vector>

#include "glisson/core/statistics.h"

namespace glisson::ui {
namespace {

constexpr std::size_t kKept = 600;  ///< pictures: twenty seconds
constexpr std::chrono::seconds kRateWindow{2};

}  // namespace

void ScreenTimes::clear() {
  seconds_.clear();
  drawn_.clear();
  count_ = 0;
}

void ScreenTimes::add(Clock::time_point taken, Clock::time_point drawn) {
  seconds_.push_back(std::chrono::duration<double>(drawn - taken).count());
  if (seconds_.size() > kKept) seconds_.pop_front();
  drawn_.push_back(drawn);
  while (drawn - drawn_.front() > kRateWindow) drawn_.pop_front();
  ++count_;
}

std::optional<double> ScreenTimes::percentile(double share) const {
  if (seconds_.empty()) return {};
  std::vector<double> sorted(seconds_.begin(), seconds_.end());
  std::sort(sorted.begin(), sorted.end());
  return interpolated_percentile(sorted, share);
}

double ScreenTimes::rate() const {
  if (drawn_.size() < 2) return 0.0;
  const double span = std::chrono::duration<double>(drawn_.back() - drawn_.front()).count();
  return span > 0.0 ? static_cast<double>(drawn_.size() - 1) / span : 0.0;
}

std::string line_of(const ScreenTimes& times) {
  const auto ms = [&](double share) { return 1e3 * times.percentile(share).value_or(0.0); };
  char text[128];
  std::snprintf(text, sizeof text,
                "camera to screen %.0f ms median, %.0f ms 99 %%, %.1f frames/s, %d pictures", ms(0.5),
                ms(0.99), times.rate(), times.count());
  return text;
}

}  // namespace glisson::ui
