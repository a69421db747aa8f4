// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/registration_box.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "box_layout.h"
#include "glisson/engine/commands/accept_registration.h"
#include "glisson/engine/commands/register.h"
#include "glisson/ui/common/panel.h"
#include "glisson/ui/common/task_button.h"

namespace glisson::ui {

RegistrationBox::RegistrationBox(EngineBridge& engine, RegistrationModel& model, QWidget* parent)
    : QWidget(parent) {
  QVBoxLayout* box = make_box_layout(this);
  QLabel* unchecked = make_warning(this);
  unchecked->setText(tr("Nobody has checked this model (Model, Quality). The picture says so."));
  unchecked->setObjectName(QStringLiteral("model_unchecked"));
  box->addWidget(unchecked);
  auto* start = new TaskButton(
      engine, tr("Register"), [] { return engine::Command(engine::Register{}); }, this);
  start->setObjectName(QStringLiteral("register"));
  box->addWidget(start);
  auto* figures = new FiguresTable(this);
  box->addWidget(figures);
  QLabel* doubts = make_warning(this);
  doubts->setObjectName(QStringLiteral("registration_doubts"));
  box->addWidget(doubts);

  auto* accept = new TaskButton(
      engine, tr("Use it nevertheless"), [] { return engine::Command(engine::AcceptRegistration{}); }, this);
  accept->setObjectName(QStringLiteral("accept_registration"));
  accept->button()->setProperty("role", QVariant());  // not the step that one takes in passing
  accept->setToolTip(
      tr("The registration was refused: what is known contradicts it. Its doubts stay in the "
         "picture."));
  box->addWidget(accept);

  couplings_.add(model.is_refused, [accept](bool is) { accept->setVisible(is); });
  couplings_.add(model.is_unchecked, [unchecked](bool is) { unchecked->setVisible(is); });
  couplings_.add(model.obstacle, [start](const QString& text) { start->set_obstacle(text); });
  couplings_.add(model.figures, [figures](const FigureRows& rows) { figures->set_rows(rows); });
  couplings_.add(model.doubts, [doubts](const QString& text) { show_warning(*doubts, text); });
}

}  // namespace glisson::ui
