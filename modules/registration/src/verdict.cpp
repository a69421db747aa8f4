// SPDX-License-Identifier: GPL-3.0-or-later
#include "verdict.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "glisson/registration/refusal.h"

namespace glisson::registration {
namespace {

/// Deviation of a cloud's points that stereo leaves at the usual distance (130 mm, 5 mm between the cameras,
/// a quarter of a pixel), m.
constexpr double kUsualNoise = 1.2e-3;
// The limits below are those of EVIDENCE.md: chosen on development patients handled as no prior knows.
/// Logarithm of the odds against the mirror image. Above kSureOdds is sure: the points' errors depend on each
/// other, and poses that were 20 mm off and more still reached 5.6.
constexpr double kSureOdds = 10.0, kEvenOdds = 0.0;
constexpr double kMuchExpected = 6e-3;  ///< m, mean over the nodes, or of a lesion
constexpr double kTurned = 0.15;        ///< share of the points
constexpr double kMarginOff = 8e-3;     ///< m
/// Probability that the organ is more than 20 mm off, or that it changed between looks. From one in a hundred
/// on it is a doubt, from one in twenty on the registration is refused.
constexpr double kElsewhereDoubt = 0.01, kElsewhere = 0.05;
/// Share by which a model is too large or too small before any camera: half a millimetre of its outline on an
/// organ of 100 mm. Standard deviation.
constexpr double kModelsSize = 5e-3;
/// Standard deviations of how large the organ is: beyond on either side lie one in fifty, and one in
/// sixteen thousand.
constexpr double kOtherSize = 2.33, kSurelyOtherSize = 4.0;
constexpr double kNever = std::numeric_limits<double>::infinity();

std::string told(const std::string& code, double found, double limit) {
  char values[48];
  std::snprintf(values, sizeof values, " %.3g %.3g", found, limit);
  return code + values;
}

}  // namespace

double strangest(double modes) {
  constexpr double kTwentieth = 1.645;  // standard normal
  const double v = 2.0 / (9.0 * std::max(1.0, modes));
  return std::pow(1.0 - v + kTwentieth * std::sqrt(v), 3);
}

Verdict judge(const Findings& found) {
  Verdict verdict;
  const auto weigh = [&](const std::string& code, double value, double doubt, double refuse, double unit) {
    if (!(value > doubt)) return;  // not a number: was not asked
    const bool refuses = value > refuse;
    verdict.doubts.push_back(told(code, unit * value, unit * (refuses ? refuse : doubt)));
    verdict.refused = verdict.refused || refuses;
  };
  weigh("cloud_noisy", found.roughness, 3.0 * kUsualNoise, 5.0 * kUsualNoise, 1e3);
  // It is always asked: what is no number then is not small.
  const auto expected_of = [](double error) { return std::isnan(error) ? kNever : error; };
  weigh("expected_error_large", expected_of(found.expected), kMuchExpected, kNever, 1e3);
  // The organ may be well known on the whole, and a lesion far from all that is seen not.
  if (!(expected_of(found.expected) > kMuchExpected))
    for (const Findings::Lesion& lesion : found.lesions)
      weigh(lesion.name + kLesionError, expected_of(lesion.expected), kMuchExpected, kNever, 1e3);
  weigh("elsewhere_probable", found.elsewhere, kElsewhereDoubt, kElsewhere, 1e2);
  weigh("looks_differ", found.looks_differ, kElsewhereDoubt, kElsewhere, 1e2);
  weigh("mirror_fits", -found.mirror_odds, -kSureOdds, -kEvenOdds, -1.0);
  weigh("points_turned", found.turned, kTurned, kNever, 1e2);
  weigh("margin_off", found.margin_off, kMarginOff, kNever, 1e3);
  const double size_sigma = std::hypot(found.size_sigma, kModelsSize);
  weigh("size_differs", std::abs(found.size), kOtherSize * size_sigma, kSurelyOtherSize * size_sigma, 1e2);
  weigh("shape_strange", found.strangeness, strangest(found.decided), kNever, 1.0);
  return verdict;
}

}  // namespace glisson::registration
