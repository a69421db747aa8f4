// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/registration_model.h"

#include "glisson/engine/parts/check.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/registration/next_look.h"
#include "glisson/registration/refusal.h"
#include "glisson/registration/rivals.h"
#include "glisson/ui/common/texts.h"

namespace glisson::ui {

RegistrationModel::RegistrationModel(EngineBridge& engine, QObject* parent)
    : QObject(parent), engine_(engine) {
  connect(&engine_, &EngineBridge::case_changed, this, &RegistrationModel::read_case);
  couplings_.add(shown_look, [this](int) {
    if (source_) read_error(*source_);
  });
  read_case();
}

void RegistrationModel::read_case() {
  const engine::CaseState& now = engine_.state();
  is_unchecked = now[part::model] && !engine::is_model_checked(now);
  if (now[part::registration] != source_) {
    shown_rival = -1;
    shown_look = -1;
  }
  source_ = now[part::registration];
  if (!now[part::registration]) {
    rivals = QStringList();
    looked_for = QStringList();
    error_words = QString();
    figures = FigureRows();
    doubts = QString();
    is_refused = false;
    return;
  }
  const Registration& r = *now[part::registration];
  is_refused = registration::is_refused(r);
  read_rivals(r);
  read_looks(r);
  read_error(r);
  FigureRows rows{
      {tr("Residual (not an accuracy)"), tr("%1 mm").arg(1e3 * r.residual, 0, 'f', 2)},
      {tr("Converged"), is_refused                                ? tr("refused")
                        : r.termination == Termination::converged ? tr("yes, %1 plateaus").arg(r.plateaus)
                                                                  : tr("no, %1 steps").arg(r.steps)}};
  if (r.expected.size() > 0)
    rows.emplace_back(tr("Expected error, mean"), tr("%1 mm").arg(1e3 * r.expected.mean(), 0, 'f', 1));
  if (!r.forces.empty()) rows.emplace_back(tr("Places where forces act"), QString::number(r.forces.size()));
  figures = rows;
  doubts = notes_text(r.doubts);
}

void RegistrationModel::read_rivals(const Registration& registration) {
  QStringList lines;
  for (std::size_t k = 0; k < registration.rivals.size(); ++k) {
    const RegistrationRival& rival = registration.rivals[k];
    const double away = registration::distance_of(rival, registration);
    const QString percent =
        rival.probability < 0.01 ? tr("under 1 %") : tr("%1 %").arg(100.0 * rival.probability, 0, 'f', 0);
    lines << tr("Other place %1: %2, %3 mm away").arg(k + 1).arg(percent).arg(1e3 * away, 0, 'f', 0);
  }
  rivals = lines;
}

void RegistrationModel::read_error(const Registration& registration) {
  QStringList words;
  if (engine_.snapshot()->stage(part::registration) != engine::StageState::current)
    words << tr("Out of date: an earlier step has changed since the registration.");
  else if (is_refused)
    words << tr("Refused: what is known contradicts that the organ lies here.");
  const bool holds = words.isEmpty();
  if (registration.expected.size() == 0)
    words << tr("How far off the organ may be is not known: register again.");
  else
    words << tr("Expected error: mean %1 mm, at most %2 mm. Ellipsoids hold a lesion in 95 of 100 cases.")
                 .arg(1e3 * registration.expected.mean(), 0, 'f', 1)
                 .arg(1e3 * registration.expected.maxCoeff(), 0, 'f', 1);
  if (const QString look = look_words(registration); holds && !look.isEmpty()) words << look;
  if (!registration.forces.empty()) words << tr("Arrows: forces, relative to one another.");
  error_words = words.join(QLatin1Char(' '));
}

void RegistrationModel::read_looks(const Registration& registration) {
  QStringList names;
  for (const LesionLooks& looks : registration.looks) names << structure_text(looks.lesion);
  looked_for = names;
}

QString RegistrationModel::look_words(const Registration& registration) const {
  const auto& model = engine_.state()[part::model];
  if (!model || model->model.mesh.vertex_count() != registration.nodes_in_camera.rows()) return {};
  const int which = shown_look;
  const LesionLooks* told = nullptr;
  double most = 0.0;
  for (std::size_t k = 0; k < registration.looks.size(); ++k) {
    const LesionLooks& looks = registration.looks[k];
    const auto best = registration::best_look(looks);
    const double gain = best ? best->now - best->after : 0.0;
    if (which == static_cast<int>(k) || (which < 0 && gain > most)) told = &looks, most = gain;
  }
  if (told == nullptr) return {};
  const std::string note = registration::look_note(model->model, *told);
  return note.empty() ? tr("%1: no single look helps much.").arg(structure_text(told->lesion))
                      : note_text(note);
}

const Points* RegistrationModel::rival_nodes() const {
  const auto& now = engine_.state()[part::registration];
  const int which = shown_rival;
  if (!now || which < 0 || which >= static_cast<int>(now->rivals.size())) return nullptr;
  return &now->rivals[static_cast<std::size_t>(which)].nodes_in_camera;
}

}  // namespace glisson::ui
