// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/core/statistics.h"

namespace glisson {

double interpolated_percentile(std::span<const double> sorted, double share) {
  require(!sorted.empty() && share >= 0.0 && share <= 1.0, "a percentile is a share of some values");
  const double place = share * (static_cast<double>(sorted.size()) - 1.0);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

}  // namespace glisson
