// SPDX-License-Identifier: GPL-3.0-or-later
// The laparoscope's calibration from pictures of a board.
#include <algorithm>

#include "apply_parts.h"
#include "glisson/stereo/picture_io.h"
#include "glisson/stereo/picture_pairs.h"

namespace glisson::engine {
namespace {

constexpr double kFindShare = 0.7;  ///< of the time, for finding the boards
constexpr int kFewestViews = 3;

void add_figures(Figures& figures, const stereo::Calibration& calibration) {
  figures["calibration_views"] = static_cast<double>(calibration.views.size());
  figures["calibration_outliers"] = static_cast<double>(std::count_if(
      calibration.views.begin(), calibration.views.end(), [](const auto& view) { return view.outlier; }));
  figures["calibration_rms_px"] = calibration.rms;
  figures["calibration_rms_left_px"] = calibration.left_rms;
  figures["calibration_rms_right_px"] = calibration.right_rms;
  figures["calibration_baseline_mm"] = 1e3 * calibration.rig.baseline();
  figures["calibration_coverage_left"] = calibration.left_coverage;
  figures["calibration_coverage_right"] = calibration.right_coverage;
  figures["calibration_epipolar_px"] = calibration.epipolar_rms;
  figures["calibration_epipolar_left_out_px"] = calibration.epipolar_left_out;
}

/// Null: cancelled.
std::shared_ptr<const stereo::BoardViews> find_boards(const CalibrateRig& command,
                                                      const RunContext& context) {
  auto views = std::make_shared<stereo::BoardViews>(command.board);
  const auto pairs = command.right.empty() ? stereo::picture_pairs(command.left).pairs
                                           : stereo::picture_pairs(command.left, command.right).pairs;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (context.cancelled()) return {};
    context.progress(static_cast<double>(i) / static_cast<double>(pairs.size()), "calibrate.find_board");
    views->add(pairs[i].name, stereo::read_picture(pairs[i].left), stereo::read_picture(pairs[i].right));
  }
  return views;
}

}  // namespace

Cancellable<Applied> apply_one(const CaseState& state, const CalibrateRig& command,
                               const RunContext& context) {
  const auto views = command.found ? command.found : find_boards(command, context.part(0.0, kFindShare));
  if (!views) return {};
  views->require(kFewestViews);
  auto calibration =
      stereo::calibrate(*views, command.options, context.part(command.found ? 0.0 : kFindShare, 1.0));
  if (!calibration) return {};
  Applied applied;
  applied.state = state;
  add_figures(applied.figures, *calibration);
  applied.figures["calibration_pairs"] = views->pairs();
  for (const stereo::ViewReport& view : calibration->views)
    if (view.outlier)
      applied.notes.push_back((view.used ? "calibration.proposed " : "calibration.outlier ") + view.name);
  applied.state.rig = std::make_shared<const StereoRig>(calibration->rig);
  CalibrationSheet sheet{views, std::move(*calibration), {}};
  sheet.coverage = stereo::coverage_picture(*views, sheet.calibration);
  applied.calibration = std::make_shared<const CalibrationSheet>(std::move(sheet));
  return applied;
}

}  // namespace glisson::engine
