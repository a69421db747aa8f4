// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/experiments/track_evaluation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "glisson/core/error.h"
#include "glisson/core/statistics.h"
#include "glisson/experiments/evaluate.h"
#include "glisson/geometry/distance.h"

namespace glisson::experiments {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

bool is_maximum(const std::string& key) { return key.find("_max_") != std::string::npos; }

}  // namespace

FrameTimes::FrameTimes(double frames_per_second) : frames_per_second_(frames_per_second) {
  require(frames_per_second > 0.0, "frames_per_second is positive");
}

void FrameTimes::add(const OverlayFrame& overlay) {
  milliseconds_.push_back(overlay.milliseconds);
  late_ += overlay.milliseconds > 1e3 / frames_per_second_;
  valid_ += overlay.level() == Level::valid;
  degraded_ += overlay.level() == Level::degraded;
}

Figures FrameTimes::counts() const {
  return {{"frames", frames()},
          {"frames_late", late_},
          {"frames_valid", valid_},
          {"frames_degraded", degraded_},
          {"frames_withdrawn", frames() - valid_ - degraded_}};
}

Figures FrameTimes::percentiles() const {
  const auto at = [&](double share) {
    return milliseconds_.empty() ? kUnknown : upper_percentile(milliseconds_, share);
  };
  return {{"frame_p50_ms", at(0.5)}, {"frame_p99_ms", at(0.99)}};
}

TrackEvaluation::TrackEvaluation(const PatientModel& model, const Registration& start,
                                 double frames_per_second)
    : model_(model),
      frozen_(start.nodes_in_camera),
      rigid_(start.camera_from_ct.apply(model.mesh.vertices)),
      times_(frames_per_second) {
  require(frozen_.rows() == rigid_.rows(), "tracking begins with a position of each node");
}

void TrackEvaluation::add(const OverlayFrame& overlay) {
  times_.add(overlay);
  if (overlay.nodes_in_camera.rows() == 0) return;
  displacement_ += point_errors(overlay.nodes_in_camera, rigid_).mean;
  ++placed_;
}

Figures TrackEvaluation::compare(const OverlayFrame& overlay, const Points& true_nodes_in_camera,
                                 const std::string& name) {
  const Points& nodes = overlay.nodes_in_camera;
  require(nodes.rows() > 0, "a frame that is compared has positions");
  Figures errors = target_errors(model_, nodes, true_nodes_in_camera, name);
  errors["tre_frozen_mean_mm"] = 1e3 * point_errors(frozen_, true_nodes_in_camera).mean;
  if (true_start_.rows() > 0) {
    errors["motion_mean_mm"] = 1e3 * point_errors(true_start_, true_nodes_in_camera).mean;
    errors["motion_error_mean_mm"] =
        1e3 * point_errors(nodes - frozen_, true_nodes_in_camera - true_start_).mean;
  }
  for (const auto& [key, value] : errors) {
    const auto [all, is_new] = sums_.emplace(key, value);
    if (!is_new) all->second = is_maximum(key) ? std::max(all->second, value) : all->second + value;
  }
  ++compared_;
  return errors;
}

void TrackEvaluation::set_true_start(const Points& true_nodes_in_camera) {
  require(true_nodes_in_camera.rows() == frozen_.rows(), "a true start has a position of each node");
  require(compared_ == 0, "the true start is set before the first comparison");
  true_start_ = true_nodes_in_camera;
}

Figures TrackEvaluation::displacement() const {
  return {{"displacement_mean_mm", placed_ > 0 ? 1e3 * displacement_ / placed_ : kUnknown}};
}

Figures TrackEvaluation::errors() const {
  Figures means = sums_;
  for (auto& [key, value] : means)
    if (!is_maximum(key)) value /= compared_;
  return means;
}

}  // namespace glisson::experiments
