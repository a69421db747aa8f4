// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/calibrate_rig.h"

#include "glisson/core/note_value.h"
#include "glisson/engine/parts/rig.h"
#include "glisson/stereo/calibration_io.h"

namespace glisson::engine {
namespace {

constexpr double kFindShare = 0.7;  ///< of the time, for finding the boards

/// Null: cancelled.
std::shared_ptr<const stereo::BoardViews> find_boards(const CalibrateRig& command,
                                                      const RunContext& context) {
  auto views = stereo::find_views(command.search, context, command.told);
  if (!views) return {};
  return std::make_shared<const stereo::BoardViews>(std::move(*views));
}

std::vector<std::string> notes_of(const stereo::Calibration& calibration) {
  std::vector<std::string> notes;
  for (const stereo::ViewReport& view : calibration.views)
    if (view.outlier)
      notes.push_back((view.used ? "calibration.proposed " : "calibration.outlier ") + note_value(view.name));
  for (std::string& doubt : stereo::calibration_doubts(calibration.rig)) notes.push_back(std::move(doubt));
  return notes;
}

Figures figures_of(const stereo::Calibration& calibration, const stereo::BoardViews& views) {
  Figures figures = stereo::calibration_figures(calibration);
  figures["calibration_pairs"] = views.pairs();
  return figures;
}

Cancellable<stereo::Calibration> calibrated(const stereo::BoardViews& views, const CalibrateRig& command,
                                            const RunContext& context) {
  stereo::CalibrateOptions options = command.options;
  if (!command.reference.empty() && views.pairs() > 0)
    options.reference =
        stereo::read_calibration_for(command.reference, views.width(), views.height(), std::nullopt);
  return stereo::calibrate(views, options, context);
}

std::shared_ptr<const CalibrationSheet> sheet_of(const std::shared_ptr<const stereo::BoardViews>& views,
                                                 stereo::Calibration calibration) {
  CalibrationSheet sheet{views, std::move(calibration), {}};
  sheet.coverage = stereo::coverage_picture(*views, sheet.calibration);
  return std::make_shared<const CalibrationSheet>(std::move(sheet));
}

}  // namespace

CommandTraits CalibrateRig::traits() const { return {.code = "calibrate", .writes = {part::rig}}; }

Cancellable<Applied> CalibrateRig::apply(const CaseState& state, const RunContext& context) const {
  const auto views = found ? found : find_boards(*this, context.part(0.0, kFindShare));
  if (!views) return {};
  auto calibration = calibrated(*views, *this, context.part(found ? 0.0 : kFindShare, 1.0));
  if (!calibration) return {};
  Applied applied{state, figures_of(*calibration, *views), notes_of(*calibration)};
  applied.state[part::rig] = std::make_shared<const StereoRig>(calibration->rig);
  applied.result = sheet_of(views, std::move(*calibration));
  return applied;
}

}  // namespace glisson::engine
