// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/registration_model.h"

#include "glisson/ui/common/texts.h"

namespace glisson::ui {
namespace {

bool is_stale(const engine::Snapshot& now, engine::Part part) {
  return now.stage(part) == engine::StageState::stale;
}

/// Made again of such an input, the part would be out of date as before.
bool has_stale_input(const engine::Snapshot& now, engine::Part part, engine::Part input) {
  return is_stale(now, input) && now.state.stamp(part).made_from.contains(input);
}

}  // namespace

RegistrationModel::RegistrationModel(EngineBridge& engine, QObject* parent)
    : QObject(parent), engine_(engine) {
  connect(&engine_, &EngineBridge::case_changed, this, &RegistrationModel::read_case);
  read_case();
}

QString RegistrationModel::requirement(const engine::Snapshot& now) {
  using engine::Part;
  if (!now.state.model) return tr("Build a model first.");
  if (!now.state.cloud) return tr("Reconstruct the surface first (Stereo).");
  if (has_stale_input(now, Part::model, Part::labels))
    return tr("The labels are out of date: segment or import them again (Segmentation).");
  if (is_stale(now, Part::model)) return tr("The model is out of date: build it again (Model).");
  if (is_stale(now, Part::landmarks))
    return tr("The landmarks are those of another model: look at them and accept them (Landmarks).");
  if (!is_stale(now, Part::cloud)) return {};
  if (has_stale_input(now, Part::cloud, Part::frame))
    return tr("The frame is of a former video: take one of the present video (Stereo).");
  if (has_stale_input(now, Part::cloud, Part::regions))
    return tr("The regions are those of another frame: draw them again or clear them (Stereo).");
  return tr("The points are out of date: reconstruct the surface again (Stereo).");
}

void RegistrationModel::read_case() {
  const engine::CaseState& now = engine_.state();
  obstacle = requirement(*engine_.snapshot());
  is_unchecked = now.model && !engine::is_model_checked(now);
  if (!now.registration) {
    figures = FigureRows();
    doubts = QString();
    return;
  }
  const Registration& r = *now.registration;
  figures = FigureRows{
      {tr("Residual (not an accuracy)"), tr("%1 mm").arg(1e3 * r.residual, 0, 'f', 2)},
      {tr("Converged"), r.termination == Termination::converged ? tr("yes, %1 plateaus").arg(r.plateaus)
                                                                : tr("no, %1 steps").arg(r.steps)}};
  doubts = notes_text(r.doubts);
}

}  // namespace glisson::ui
