// SPDX-License-Identifier: GPL-3.0-or-later
// The laparoscope's calibration from pictures of a board.

#include "apply_parts.h"
#include "glisson/stereo/board_series.h"

namespace glisson::engine {
namespace {

constexpr double kFindShare = 0.7;  ///< of the time, for finding the boards
constexpr int kFewestViews = 3;

/// Null: cancelled.
std::shared_ptr<const stereo::BoardViews> find_boards(const CalibrateRig& command,
                                                      const RunContext& context) {
  auto views = std::make_shared<stereo::BoardViews>(command.board);
  const auto pairs = command.right.empty() ? stereo::picture_pairs(command.left).pairs
                                           : stereo::picture_pairs(command.left, command.right).pairs;
  if (!stereo::add_pairs(*views, pairs, context)) return {};
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
  applied.figures = stereo::calibration_figures(*calibration);
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
