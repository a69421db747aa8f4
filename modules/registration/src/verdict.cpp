// SPDX-License-Identifier: GPL-3.0-or-later
#include "verdict.h"

#include <cstdio>
#include <limits>

namespace glisson::registration {
namespace {

/// Deviation of a cloud's points that stereo leaves at the usual distance (130 mm, 5 mm between the cameras,
/// a quarter of a pixel), m.
constexpr double kUsualNoise = 1.2e-3;
/// Of the cloud against its mirror image: ln 99.
constexpr double kSureOdds = 4.595;

constexpr double kMuchExpected = 8e-3;  ///< m, mean over the nodes

std::string told(const char* code, double found, double limit) {
  char text[96];
  std::snprintf(text, sizeof text, "%s %.3g %.3g", code, found, limit);
  return text;
}

}  // namespace

Verdict judge(const Findings& found) {
  Verdict verdict;
  const auto weigh = [&](const char* code, double value, double doubt, double refuse, double unit) {
    if (!(value > doubt)) return;  // not a number: was not asked
    const bool refuses = value > refuse;
    verdict.doubts.push_back(told(code, unit * value, unit * (refuses ? refuse : doubt)));
    verdict.refused = verdict.refused || refuses;
  };
  weigh("cloud_noisy", found.roughness, 3.0 * kUsualNoise, 5.0 * kUsualNoise, 1e3);
  weigh("expected_error_large", found.expected, kMuchExpected, std::numeric_limits<double>::infinity(), 1e3);
  weigh("mirror_fits", -found.mirror_odds, -kSureOdds, 0.0, -1.0);
  return verdict;
}

}  // namespace glisson::registration
