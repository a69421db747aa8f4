// SPDX-License-Identifier: GPL-3.0-or-later
#include "live_tally.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "glisson/core/statistics.h"
#include "live_truth.h"
#include "of_none.h"

namespace glisson::experiments {
namespace {

constexpr double kFrameRate = 30.0;  ///< of the films
constexpr int kEnoughShown = 30;     ///< valid frames of a fault, to be compared with a frozen model

double seconds(int frames) { return frames >= 0 ? frames / kFrameRate : std::nan(""); }

std::string percent(int part, int whole) { return figure_text("%.1f", 100.0 * share_of(part, whole)); }

/// Metres as millimetres, a mean.
std::string mean_mm(double sum, int count) {
  return figure_text("%.1f", count > 0 ? 1e3 * sum / count : std::nan(""));
}

std::string row(const std::string& name, const FaultTally& tally) {
  char line[240];
  std::snprintf(line, sizeof line, "%-20s %-20s %6s %6d %9s %9s %6d %9s %7s %7s", name.c_str(),
                tally.most_shown().c_str(), tally.latest < 0 ? "-" : std::to_string(tally.latest).c_str(),
                tally.far, percent(tally.far_hidden_before, tally.far).c_str(),
                percent(tally.far_hidden, tally.far).c_str(), tally.near,
                percent(tally.near_valid, tally.near).c_str(),
                mean_mm(tally.shown_sum, tally.shown_frames).c_str(),
                mean_mm(tally.frozen_sum, tally.shown_frames).c_str());
  return line;
}

bool has_right_start(const LiveFault& fault) {
  return fault.start_turn.isIdentity() && fault.start_shift.isZero() && fault.start_lift == 0.0 &&
         fault.drift.isZero() && !fault.calibration && !shows_another_organ(fault);
}

}  // namespace

void FaultTally::add(const std::vector<JudgedFrame>& run) {
  int wrong_from = -1;  // the first frame of a run that is over 10 mm and valid
  for (const JudgedFrame& judged : run) {
    const bool valid = judged.is_valid();
    ++shown[validity_code(judged.overlay.validity)];
    milliseconds.push_back(judged.overlay.milliseconds);
    error_sum += judged.error;
    ++frames;
    if (valid) {
      ++shown_frames;
      shown_sum += judged.error;
      frozen_sum += judged.frozen;
    }
    if (judged.error > kFarFrame) {
      ++far;
      far_hidden += !valid;
      far_hidden_before += !judged.shown_before();
      latest = std::max(latest, 0);
    } else if (judged.error < kNearFrame) {
      ++near;
      near_valid += valid;
      near_sound += !judged.faulty;
      near_sound_valid += !judged.faulty && valid;
    }
    const bool is_wrong = valid && judged.error > kFarFrame;
    if (is_wrong && wrong_from < 0) wrong_from = judged.frame;
    if (wrong_from >= 0) latest = std::max(latest, judged.frame + (is_wrong ? 1 : 0) - wrong_from);
    if (!is_wrong) wrong_from = -1;
  }
}

void FaultTally::add_return(const std::vector<JudgedFrame>& run, int good_from) {
  if (good_from < 0) return;
  int first = run.back().frame + 1;
  for (const JudgedFrame& judged : run)
    if (judged.frame >= good_from && judged.frame < first && judged.error < kNearFrame && judged.is_valid())
      first = judged.frame;
  returned = std::max(returned, first - good_from);
}

void FaultTally::merge(const FaultTally& other) {
  far += other.far;
  far_hidden += other.far_hidden;
  far_hidden_before += other.far_hidden_before;
  near += other.near;
  near_valid += other.near_valid;
  near_sound += other.near_sound;
  near_sound_valid += other.near_sound_valid;
  latest = std::max(latest, other.latest);
  returned = std::max(returned, other.returned);
  milliseconds.insert(milliseconds.end(), other.milliseconds.begin(), other.milliseconds.end());
}

std::string FaultTally::most_shown() const {
  std::string name = "valid";
  int most = 0;
  for (const auto& [code, count] : shown)
    if (code != "valid" && count > most) {
      name = code;
      most = count;
    }
  return name;
}

void LesionTally::add(const JudgedFrame& judged, bool is_sound) {
  const guidance::LesionOptions options;
  for (std::size_t i = 0; i < judged.lesion_errors.size(); ++i) {
    const LesionVerdict& verdict = judged.overlay.lesions[i];
    const double error = judged.lesion_errors[i];
    const bool valid = verdict.level == Level::valid;
    if (error > kFarFrame) {
      ++far;
      far_hidden += !valid;
    } else if (error < kNearFrame && is_sound) {
      ++near_sound;
      near_sound_valid += valid;
    }
    roc.add(lesion_score(verdict, options.margin), error, is_sound);
    if (verdict.level == Level::withdrawn || !(verdict.reach > 0.0)) continue;
    ++drawn;
    // As a ball that reaches as far: the way of the error is not kept.
    inside += error <= verdict.reach;
  }
}

bool Untried::can_try(const LiveStage& stage, const LiveFault& fault) {
  const bool can = can_run(stage, fault);
  const auto known = std::ranges::find(tried_, fault.name, &std::pair<std::string, bool>::first);
  if (known == tried_.end())
    tried_.emplace_back(fault.name, can);
  else
    known->second = known->second || can;
  return can;
}

std::vector<std::string> Untried::names() const {
  std::vector<std::string> names;
  for (const auto& [name, was_tried] : tried_)
    if (!was_tried) names.push_back(name);
  return names;
}

void LiveTally::add(const LiveFault& fault, const std::vector<JudgedFrame>& run) {
  if (!tallies_.contains(fault.name)) {
    names_.push_back(fault.name);
    if (has_right_start(fault)) comparable_.push_back(fault.name);
  }
  FaultTally& tally = tallies_[fault.name];
  tally.add(run);
  tally.add_return(run, fault.elsewhere_from);
  for (const JudgedFrame& judged : run) {
    roc_.add(evidence_score(judged), judged.error, !judged.faulty);
    lesions_.add(judged, !judged.faulty);
  }
}

FaultTally LiveTally::all() const {
  FaultTally all;
  for (const std::string& name : names_) all.merge(tallies_.at(name));
  return all;
}

void LiveTally::tell_faults(const std::string& title, LiveProof& proof) const {
  if (!proof.table.empty()) proof.table.emplace_back();
  char head[240];
  std::snprintf(head, sizeof head, "%-20s %-20s %6s %6s %9s %9s %6s %9s %7s %7s", title.c_str(), "shown as",
                "late", ">10mm", "hidden was", "hidden", "<3mm", "valid %", "error", "frozen");
  proof.table.emplace_back(head);
  for (const std::string& name : names_) proof.table.push_back(row(name, tallies_.at(name)));
  proof.table.push_back(row("all", all()));
}

void LiveTally::tell_lesions(const std::string& title, const std::string& prefix, LiveProof& proof) const {
  if (lesions_.roc.empty()) return;
  proof.figures[prefix + "lesion_far_frames"] = lesions_.far;
  proof.figures[prefix + "lesion_far_hidden_share"] = share_of(lesions_.far_hidden, lesions_.far);
  proof.figures[prefix + "lesion_near_sound_valid_share"] =
      share_of(lesions_.near_sound_valid, lesions_.near_sound);
  proof.figures[prefix + "lesion_inside_share"] = share_of(lesions_.inside, lesions_.drawn);
  proof.figures[prefix + "lesion_roc_area"] = lesions_.roc.area();
  proof.table.emplace_back();
  for (const std::string& line : lesions_.roc.table(title + ", ROC of single lesions by their reach"))
    proof.table.push_back(line);
}

void LiveTally::sum_up(const std::string& title, const std::string& prefix, LiveProof& proof) const {
  if (names_.empty()) return;
  tell_faults(title, proof);
  proof.table.emplace_back();
  for (const std::string& line : roc_.table(title + ", ROC of the evidence of one frame"))
    proof.table.push_back(line);
  tell_lesions(title, prefix, proof);
  const FaultTally whole = all();
  for (const auto& [name, key] : {std::pair{"none", "still_mean_mm"}, {"scope_moves", "scope_mean_mm"}})
    if (const auto found = tallies_.find(name); found != tallies_.end())
      proof.figures[prefix + key] = 1e3 * found->second.error_sum / found->second.frames;
  double of_frozen = std::nan("");
  for (const std::string& name : comparable_)
    if (const FaultTally& one = tallies_.at(name); one.shown_frames >= kEnoughShown && one.frozen_sum > 0.0)
      of_frozen = std::fmax(of_frozen, one.shown_sum / one.frozen_sum);
  proof.figures[prefix + "of_frozen_share"] = of_frozen;
  proof.figures[prefix + "roc_area"] = roc_.area();
  proof.figures[prefix + "far_frames"] = whole.far;
  proof.figures[prefix + "far_hidden_share"] = share_of(whole.far_hidden, whole.far);
  proof.figures[prefix + "far_hidden_before_share"] = share_of(whole.far_hidden_before, whole.far);
  proof.figures[prefix + "near_valid_share"] = share_of(whole.near_valid, whole.near);
  proof.figures[prefix + "near_sound_valid_share"] = share_of(whole.near_sound_valid, whole.near_sound);
  proof.figures[prefix + "latest_seconds"] = seconds(whole.latest);
  proof.figures[prefix + "return_seconds"] = seconds(whole.returned);
  proof.figures[prefix + "frame_p50_ms"] = lower_percentile(whole.milliseconds, 0.5);
  proof.figures[prefix + "frame_p99_ms"] = lower_percentile(whole.milliseconds, 0.99);
}

}  // namespace glisson::experiments
