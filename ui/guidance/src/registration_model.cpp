// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/registration_model.h"

#include "glisson/engine/commands/undo_registration.h"
#include "glisson/engine/parts/check.h"
#include "glisson/engine/parts/former_registration.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/registration/error_model.h"
#include "glisson/registration/next_look.h"
#include "glisson/registration/refusal.h"
#include "glisson/registration/rivals.h"
#include "glisson/ui/common/being_made.h"
#include "glisson/ui/common/texts.h"

namespace glisson::ui {

RegistrationModel::RegistrationModel(EngineBridge& engine, QObject* parent)
    : QObject(parent), engine_(engine) {
  connect(&engine_, &EngineBridge::case_changed, this, &RegistrationModel::read_case);
  connect(&engine_, &EngineBridge::tasks_changed, this, &RegistrationModel::read_tasks);
  couplings_.add(shown_look, [this](int) {
    if (source_) read_error(*source_);
  });
  read_case();
}

void RegistrationModel::read_tasks() {
  is_being_made = ui::is_being_made(engine_, part::registration, engine::Lane::work);
}

QString RegistrationModel::wait_words() {
  return tr("A new registration is being computed: look at it first.");
}

void RegistrationModel::read_case() {
  const engine::CaseState& now = engine_.state();
  is_unchecked = now[part::model] && !engine::is_model_checked(now);
  has_former = engine::has_former_registration(now);
  can_undo = has_former && !engine_.snapshot()->tracking;
  const bool is_new = now[part::registration] != source_;
  source_ = now[part::registration];
  if (is_new) shown_rival = -1;
  if (!now[part::registration]) {
    holds = false;
    rivals = QStringList();
    rival_words = QStringList();
    spots = SpotRows();
    looked_for = QStringList();
    look_words_.clear();
    shown_look = -1;
    error_words = QString();
    figures = FigureRows();
    doubts = QString();
    notes = QString();
    is_refused = false;
    return;
  }
  const Registration& r = *now[part::registration];
  is_refused = registration::is_refused(r);
  holds = !is_refused && engine_.snapshot()->stage(part::registration) == engine::StageState::current;
  read_rivals(r);
  read_spots(r);
  if (is_new) {
    read_looks(r);
    shown_look = -1;
  }
  read_error(r);
  FigureRows rows{{tr("Residual (not an accuracy)"), tr("%1 mm").arg(1e3 * r.residual, 0, 'f', 2)},
                  {tr("Computation"), is_refused ? tr("refused") : termination_words(r)}};
  if (holds && r.expected.size() > 0)
    rows.emplace_back(tr("Expected error, mean"), tr("%1 mm").arg(1e3 * r.expected.mean(), 0, 'f', 1));
  if (!r.forces.empty()) rows.emplace_back(tr("Places where forces act"), QString::number(r.forces.size()));
  figures = rows;
  doubts = notes_text(r.doubts);
  notes = notes_text(r.notes);
}

QString RegistrationModel::termination_words(const Registration& registration) {
  switch (registration.termination) {
    case Termination::converged:
      return tr("came to rest");
    case Termination::stalled:
      return tr("stalled");
    case Termination::step_limit:
      return tr("stopped at its limit");
    case Termination::diverged:
      break;
  }
  return tr("failed");
}

void RegistrationModel::read_rivals(const Registration& registration) {
  QStringList lines, words;
  for (std::size_t k = 0; k < registration.rivals.size(); ++k) {
    const RegistrationRival& rival = registration.rivals[k];
    const double away = registration::distance_of(rival, registration);
    const QString percent =
        rival.probability < 0.01 ? tr("under 1 %") : tr("%1 %").arg(100.0 * rival.probability, 0, 'f', 0);
    lines << tr("Other place %1: %2, %3 mm away").arg(k + 1).arg(percent).arg(1e3 * away, 0, 'f', 0);
    words << tr("%1: %2, %3 mm", "other place").arg(k + 1).arg(percent).arg(1e3 * away, 0, 'f', 0);
  }
  rivals = lines;
  rival_words = words;
}

void RegistrationModel::read_spots(const Registration& registration) {
  SpotRows rows;
  if (!holds) {
    spots = rows;
    return;
  }
  const auto add = [&rows](Label lesion, const QString& name, const QString& kind,
                           const Eigen::Matrix3d& covariance) {
    rows.push_back({lesion, name, kind,
                    tr("%1 mm").arg(1e3 * registration::mean_error(covariance), 0, 'f', 1),
                    tr("±%1 mm").arg(1e3 * registration::half_axes_95(covariance)[0], 0, 'f', 1)});
  };
  for (const LesionSpread& lesion : registration.lesions)
    add(lesion.lesion, structure_text(lesion.lesion), {}, lesion.covariance);
  for (const ForkSpread& fork : registration.forks)
    add(Label{0}, structure_text(fork.tree), tr("fork %1").arg(fork.order), fork.covariance);
  spots = rows;
}

void RegistrationModel::undo() {
  if (can_undo) engine_.post(engine::UndoRegistration{});
}

void RegistrationModel::read_error(const Registration& registration) {
  QStringList words;
  if (engine_.snapshot()->stage(part::registration) != engine::StageState::current)
    words << tr("Out of date: an earlier step has changed since the registration.");
  else if (is_refused)
    words << tr("Refused: what is known contradicts that the organ lies here.");
  else if (registration.expected.size() == 0)
    words << tr("How far off the organ may be is not known: register again.");
  else
    words << tr("Expected error: mean %1 mm, at most %2 mm. Ellipsoids hold a lesion in 95 of 100 cases.")
                 .arg(1e3 * registration.expected.mean(), 0, 'f', 1)
                 .arg(1e3 * registration.expected.maxCoeff(), 0, 'f', 1);
  if (const QString look = look_words(); holds && !look.isEmpty()) words << look;
  if (!registration.forces.empty()) words << tr("Arrows: forces, relative to one another.");
  error_words = words.join(QLatin1Char(' '));
}

void RegistrationModel::read_looks(const Registration& registration) {
  QStringList names;
  look_words_.clear();
  helped_most_ = -1;
  double most = 0.0;
  const PatientModel model = engine::effective_model(engine_.state());
  const bool is_of_it = model.mesh.vertex_count() == registration.nodes_in_camera.rows();
  for (const LesionLooks& looks : registration.looks) {
    if (!is_of_it) break;
    const auto best = registration::best_look(looks);
    if (best && best->now - best->after > most) {
      most = best->now - best->after;
      helped_most_ = static_cast<int>(names.size());
    }
    names << structure_text(looks.lesion);
    look_words_ << (best ? note_text(registration::look_note(model, looks))
                         : tr("%1: no single look helps much.").arg(names.back()));
  }
  looked_for = names;
}

QString RegistrationModel::look_words() const {
  const int which = shown_look >= 0 ? shown_look.value() : helped_most_;
  return look_words_.value(which);
}

const Points* RegistrationModel::rival_nodes() const {
  const auto& now = engine_.state()[part::registration];
  const int which = shown_rival;
  if (!now || which < 0 || which >= static_cast<int>(now->rivals.size())) return nullptr;
  return &now->rivals[static_cast<std::size_t>(which)].nodes_in_camera;
}

}  // namespace glisson::ui
