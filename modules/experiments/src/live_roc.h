// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glisson/core/json_file.h"
#include "live_run.h"

namespace glisson::experiments {

inline constexpr double kFarFrame = 10e-3, kNearFrame = 3e-3;  ///< metres of error: over and under

/// How well a number tells far frames from near ones, whatever the limit.
class Roc {
 public:
  /// @param score 1 and more: not valid. @param error metres. @param is_sound it is no fault's frame.
  void add(double score, double error, bool is_sound);
  bool empty() const { return far_.empty() && sound_.empty(); }
  /// Area under the curve: how probably a far frame scores more than a near one without a fault. Not a number
  /// where there are none of either; nor are the shares of none.
  double area() const;
  /// Shares of far frames that are not valid and of near ones without a fault that are, were all limits
  /// `factor` times as large.
  double far_hidden(double factor) const;
  double near_valid(double factor) const;
  /// A line each factor, under a head.
  std::vector<std::string> table(const std::string& title) const;

 private:
  std::vector<double> far_, sound_;  ///< scores; over 10 mm, and under 3 without a fault
};

/// From 1 on one of the judge's limits is reached by what was measured last, without hysteresis; infinite
/// where the tracker itself has no overlay.
double evidence_score(const JudgedFrame& judged);
/// Likewise of one lesion, by the reach of its region.
double lesion_score(const LesionVerdict& verdict, double margin);

}  // namespace glisson::experiments
