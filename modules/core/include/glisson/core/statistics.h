// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "glisson/core/error.h"

/// @file
/// Order statistics, once for the whole house. Where a list has no value exactly at the wanted place, its two
/// neighbours differ in what they are called: `upper_` and `lower_` take one of the list's own values,
/// `interpolated_` one between them. Values must not be NaN. Pure functions, safe from any thread.

namespace glisson {

/// Deviation of a normal distribution over its median absolute deviation.
constexpr double kDeviationPerMad = 1.4826;
/// Median of the square of a standard normal variable.
constexpr double kMedianOfChiSquare = 0.4549;

/// The value at `rank` (0: the least) when sorted. Takes linear time.
/// @pre rank < values.size()
template <class T>
T at_rank(std::vector<T> values, std::size_t rank) {
  require(rank < values.size(), "a rank lies within its list");
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

/// The median; of an even count the larger of the two in the middle. Any order.
/// @pre not empty
template <class T>
T upper_median(std::vector<T> values) {
  const std::size_t middle = values.size() / 2;
  return at_rank(std::move(values), middle);
}

/// Median of |value - centre| (upper). Times kDeviationPerMad it estimates a deviation that outliers do not
/// move.
/// @pre not empty
template <class T>
T median_absolute_deviation(std::vector<T> values, T centre) {
  for (T& value : values) value = std::abs(value - centre);
  return upper_median(std::move(values));
}

/// Median and scaled median absolute deviation: mean and deviation of a normal distribution, whatever a few
/// outliers are.
template <class T>
struct Spread {
  T middle{};
  double deviation = 0.0;
};
/// @pre not empty
template <class T>
Spread<T> robust_spread(std::vector<T> values) {
  const T middle = upper_median(values);
  return {middle,
          kDeviationPerMad * static_cast<double>(median_absolute_deviation(std::move(values), middle))};
}

/// The value below which `share` of the others lie; the next smaller (larger) one where the place is between
/// two. Any order.
/// @pre not empty; share in [0, 1]
template <class T>
T lower_percentile(std::vector<T> values, double share) {
  require(!values.empty() && share >= 0.0 && share <= 1.0, "a percentile is a share of some values");
  const double place = share * static_cast<double>(values.size() - 1);
  return at_rank(std::move(values), static_cast<std::size_t>(place));
}
template <class T>
T upper_percentile(std::vector<T> values, double share) {
  require(!values.empty() && share >= 0.0 && share <= 1.0, "a percentile is a share of some values");
  const double place = share * static_cast<double>(values.size() - 1);
  return at_rank(std::move(values), static_cast<std::size_t>(std::ceil(place)));
}

/// The same by linear interpolation between the two neighbours (share 0.5 is the usual median).
/// @param sorted ascending
/// @pre not empty; share in [0, 1]
double interpolated_percentile(std::span<const double> sorted, double share);

}  // namespace glisson
