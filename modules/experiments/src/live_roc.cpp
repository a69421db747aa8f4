// SPDX-License-Identifier: GPL-3.0-or-later
#include "live_roc.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "of_none.h"

namespace glisson::experiments {
namespace {

constexpr double kFactors[] = {0.4, 0.6, 0.8, 1.0, 1.25, 1.6, 2.5, 4.0};

/// The share of scores from `limit` on; not a number of none.
double share_from(const std::vector<double>& scores, double limit) {
  if (scores.empty()) return std::nan("");
  const auto from =
      std::count_if(scores.begin(), scores.end(), [limit](double score) { return score >= limit; });
  return static_cast<double>(from) / static_cast<double>(scores.size());
}

}  // namespace

void Roc::add(double score, double error, bool is_sound) {
  if (error > kFarFrame) far_.push_back(score);
  if (error < kNearFrame && is_sound) sound_.push_back(score);
}

double Roc::area() const {
  if (far_.empty() || sound_.empty()) return std::nan("");
  std::vector<double> sorted = sound_;
  std::sort(sorted.begin(), sorted.end());
  double wins = 0.0;
  for (const double score : far_) {
    const auto [low, high] = std::equal_range(sorted.begin(), sorted.end(), score);
    wins += static_cast<double>(low - sorted.begin()) + 0.5 * static_cast<double>(high - low);
  }
  return wins / (static_cast<double>(far_.size()) * static_cast<double>(sorted.size()));
}

double Roc::far_hidden(double factor) const { return share_from(far_, factor); }
double Roc::near_valid(double factor) const { return 1.0 - share_from(sound_, factor); }

std::vector<std::string> Roc::table(const std::string& title) const {
  char line[160];
  std::snprintf(line, sizeof line, "%s: area %s", title.c_str(), figure_text("%.4f", area()).c_str());
  std::vector<std::string> lines{line, "limits times   >10 mm hidden %   <3 mm valid %"};
  for (const double factor : kFactors) {
    std::snprintf(line, sizeof line, "%12.2f %17s %15s", factor,
                  figure_text("%.1f", 100.0 * far_hidden(factor)).c_str(),
                  figure_text("%.1f", 100.0 * near_valid(factor)).c_str());
    lines.emplace_back(line);
  }
  return lines;
}

double evidence_score(const JudgedFrame& judged) {
  const Validity validity = judged.overlay.validity;
  if (!is_followed(validity) || validity == Validity::residual_too_large)
    return std::numeric_limits<double>::infinity();
  return judged.overlay.evidence.judged ? judged.strength : 0.0;
}

double lesion_score(const LesionVerdict& verdict, double margin) {
  if (verdict.reason == LesionReason::with_the_whole) return std::numeric_limits<double>::infinity();
  return verdict.reach / margin;
}

}  // namespace glisson::experiments
