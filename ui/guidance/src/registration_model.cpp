// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/registration_model.h"

#include "glisson/engine/commands/register.h"
#include "glisson/engine/parts/check.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/registration/refusal.h"
#include "glisson/ui/common/texts.h"

namespace glisson::ui {

RegistrationModel::RegistrationModel(EngineBridge& engine, QObject* parent)
    : QObject(parent), engine_(engine) {
  connect(&engine_, &EngineBridge::case_changed, this, &RegistrationModel::read_case);
  read_case();
}

void RegistrationModel::read_case() {
  const engine::CaseState& now = engine_.state();
  obstacle = obstacle_text(engine::obstacle(*engine_.snapshot(), engine::Register{}));
  is_unchecked = now[part::model] && !engine::is_model_checked(now);
  if (!now[part::registration]) {
    figures = FigureRows();
    doubts = QString();
    is_refused = false;
    return;
  }
  const Registration& r = *now[part::registration];
  is_refused = registration::is_refused(r);
  figures = FigureRows{
      {tr("Residual (not an accuracy)"), tr("%1 mm").arg(1e3 * r.residual, 0, 'f', 2)},
      {tr("Converged"), is_refused                                ? tr("refused")
                        : r.termination == Termination::converged ? tr("yes, %1 plateaus").arg(r.plateaus)
                                                                  : tr("no, %1 steps").arg(r.steps)}};
  doubts = notes_text(r.doubts);
}

}  // namespace glisson::ui
