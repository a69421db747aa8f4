// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/model/load_trial_box.h"
#include "glisson/ui/common/texts.h"

#include <QLabel>
#include <QLocale>
#include <QMouseEvent>
#include <QPushButton>
#include <QShortcut>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "glisson/engine/commands/start_trial.h"
#include "glisson/engine/commands/stop_trial.h"
#include "glisson/ui/common/error_texts.h"
#include "glisson/ui/common/panel.h"

namespace glisson::ui {

LoadTrialBox::LoadTrialBox(EngineBridge& engine, LinkedViews& views, QWidget* parent)
    : QWidget(parent), engine_(engine), views_(views) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(5);
  button_ = new QPushButton(tr("Try a load"), this);
  button_->setObjectName(QStringLiteral("try_load"));
  button_->setCheckable(true);
  layout->addWidget(button_);
  message_ = make_explanation({}, this);
  message_->setObjectName(QStringLiteral("trial_message"));
  layout->addWidget(message_);
  rate_ = new QLabel(this);
  rate_->setObjectName(QStringLiteral("trial_rate"));
  load_ = new QLabel(this);
  load_->setObjectName(QStringLiteral("trial_load"));
  for (QLabel* label : {rate_, load_}) {
    layout->addWidget(label);
    label->hide();
  }
  force_ = new QLabel(&views_.volume());
  force_->setObjectName(QStringLiteral("trial_force"));
  force_->setProperty("role", "view-letter");
  force_->setAttribute(Qt::WA_TransparentForMouseEvents);
  force_->hide();
  escape_ = new QShortcut(Qt::Key_Escape, this);
  escape_->setEnabled(false);
  connect(escape_, &QShortcut::activated, this, [this] { end(); });
  connect(button_, &QPushButton::toggled, this, [this](bool on) { on ? begin() : end(); });
  connect(&engine_, &EngineBridge::trial_changed, this, &LoadTrialBox::show_trial);
  connect(&engine_, &EngineBridge::finished, this, &LoadTrialBox::take);
  show_message({}, false);
}

void LoadTrialBox::begin() {
  if (on_) return;
  on_ = true;
  started_ = false;
  escape_->setEnabled(true);
  views_.volume().installEventFilter(this);
  views_.volume().set_taken(this, true);
  show_message(tr("Preparing…"), false);
  start_ = engine_.post(engine::StartTrial{});
}

void LoadTrialBox::end(const QString& why, bool is_problem) {
  if (!on_) return;
  on_ = false;
  escape_->setEnabled(false);
  views_.volume().removeEventFilter(this);
  views_.volume().set_taken(this, false);
  views_.volume().unsetCursor();
  pull_.reset();
  // Cancels a start that still waits, and stops one that runs: whichever applies.
  engine_.cancel(start_);
  engine_.post(engine::StopTrial{});
  const QSignalBlocker quiet(button_);
  button_->setChecked(false);
  rate_->hide();
  load_->hide();
  draw({});
  show_message(why, is_problem);
}

void LoadTrialBox::take(const engine::Outcome& outcome) {
  if (!on_ || outcome.id != start_) return;
  if (outcome.status == engine::Status::failed) return end(error_text(outcome.error), true);
  if (outcome.status == engine::Status::cancelled) return end();
  started_ = true;
  show_message(tr("Press on the liver in the 3D view and drag."), false);
  views_.volume().setCursor(Qt::PointingHandCursor);
  show_trial();
}

void LoadTrialBox::show_trial() {
  if (!on_ || !started_) return;
  const std::shared_ptr<const engine::TrialState> trial = engine_.snapshot()->trial;
  if (!trial) return end(tr("The model has changed: the trial has ended."));
  if (trial->inverted_tetrahedra > 0)
    return end(
        tr("Stopped: this pull turns elements of the mesh inside out. The rest shape is drawn. Pull less, "
           "or elsewhere."),
        true);
  if (trial->termination)
    return end(tr("Stopped: the computation did not converge under this pull. The rest shape is drawn."),
               true);
  draw(*trial);
  show_figures(*trial);
}

void LoadTrialBox::draw(const engine::TrialState& trial) {
  RenderView& view = views_.volume();
  // The scene may already show another model, or none yet.
  if (trial.nodes.rows() > 0 && trial.nodes.rows() != view.patient().node_count()) return;
  view.patient().set_loaded_nodes(trial.nodes);
  const bool pulls = trial.pull && trial.nodes.rows() > 0;
  force_->setVisible(pulls);
  if (pulls) {
    const Eigen::Vector3d& target = trial.pull->target;
    view.patient().set_pull(scene::PatientScene::Pull{trial.grabbed, target});
    force_->setText(tr("%1 N").arg(trial.force.norm(), 0, 'f', 1));
    force_->adjustSize();
    if (const auto at = view.patient().view_point(target, view.aspect()))
      force_->move(
          std::clamp(static_cast<int>(at->x() * view.width()) + 12, 0, view.width() - force_->width()),
          std::clamp(static_cast<int>(at->y() * view.height()) - force_->height() / 2, 0,
                     view.height() - force_->height()));
  } else {
    view.patient().set_pull(std::nullopt);
  }
  view.update();
}

void LoadTrialBox::show_figures(const engine::TrialState& trial) {
  if (trial.steps == 0) return;
  const QLocale locale;
  rate_->setText(trial.hertz > 0.0 ? tr("%1 Hz   %2 ms a step   %3 elements")
                                         .arg(trial.hertz, 0, 'f', 0)
                                         .arg(trial.milliseconds, 0, 'f', 1)
                                         .arg(locale.toString(trial.tetrahedra))
                                   : tr("%1 ms a step   %2 elements")
                                         .arg(trial.milliseconds, 0, 'f', 1)
                                         .arg(locale.toString(trial.tetrahedra)));
  load_->setText(tr("Pull %1 N, organ moved by up to %2 mm")
                     .arg(trial.force.norm(), 0, 'f', 1)
                     .arg(1e3 * trial.displacement_max, 0, 'f', 1));
  rate_->show();
  load_->show();
}

void LoadTrialBox::show_message(const QString& sentence, bool is_problem) {
  message_->setText(sentence);
  message_->setVisible(!sentence.isEmpty());
  set_style_property(message_, "role", is_problem ? QStringLiteral("error") : QStringLiteral("explanation"));
}

Eigen::Vector2d LoadTrialBox::place(const QPointF& at) const {
  const RenderView& view = views_.volume();
  return {at.x() / std::max(1, view.width()), at.y() / std::max(1, view.height())};
}

bool LoadTrialBox::eventFilter(QObject* watched, QEvent* event) {
  const auto* mouse = dynamic_cast<QMouseEvent*>(event);
  if (watched != &views_.volume() || mouse == nullptr) return QWidget::eventFilter(watched, event);
  const bool left = mouse->button() == Qt::LeftButton;
  switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
      if (pull_) return true;  // the camera keeps still while a point is held
      return left && grab(mouse->position());
    case QEvent::MouseMove:
      if (!pull_) return false;
      drag(mouse->position());
      return true;
    case QEvent::MouseButtonRelease:
      if (!pull_) return false;
      if (left) let_go();
      return true;
    default:
      return false;
  }
}

bool LoadTrialBox::grab(const QPointF& at) {
  if (!started_) return false;
  RenderView& view = views_.volume();
  const Eigen::Vector2d p = place(at);
  const auto hit = view.patient().surface_hit(p.x(), p.y(), view.aspect());
  if (!hit) return false;
  pull_ = engine::TrialPull{hit->triangle, hit->barycentric, hit->point};
  view.setCursor(Qt::ClosedHandCursor);
  engine_.submit_pull(pull_);
  return true;
}

void LoadTrialBox::drag(const QPointF& at) {
  RenderView& view = views_.volume();
  const Eigen::Vector2d p = place(at);
  const Eigen::Vector3d target = view.patient().point_beside(pull_->target, p.x(), p.y(), view.aspect());
  if (!target.allFinite()) return;
  pull_->target = target;
  engine_.submit_pull(pull_);
}

void LoadTrialBox::let_go() {
  pull_.reset();
  views_.volume().setCursor(Qt::PointingHandCursor);
  engine_.submit_pull(std::nullopt);
}

}  // namespace glisson::ui
