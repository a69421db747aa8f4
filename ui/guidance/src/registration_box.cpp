// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/registration_box.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <array>

#include "box_layout.h"
#include "glisson/engine/commands/accept_registration.h"
#include "glisson/engine/commands/choose_rival.h"
#include "glisson/engine/commands/register.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/ui/common/panel.h"
#include "glisson/ui/common/task_button.h"
#include "glisson/ui/guidance/rival_pictures.h"

namespace glisson::ui {

RegistrationBox::RegistrationBox(EngineBridge& engine, RegistrationModel& model, PlacingModel& placing,
                                 QWidget* parent)
    : QWidget(parent) {
  QVBoxLayout* box = make_box_layout(this);
  QLabel* unchecked = make_warning(this);
  unchecked->setText(tr("Nobody has checked this model (Model, Quality). The picture says so."));
  unchecked->setObjectName(QStringLiteral("model_unchecked"));
  box->addWidget(unchecked);
  box->addLayout(make_method_row(model));
  auto* start = new TaskButton(
      engine, tr("Register"),
      [&model] {
        engine::Register command;
        command.method = model.method;
        return engine::Command(command);
      },
      this);
  start->setObjectName(QStringLiteral("register"));
  start->watch(engine::Register{});
  box->addWidget(start);
  box->addWidget(make_undo(model));
  auto* figures = new FiguresTable(this);
  box->addWidget(figures);
  QLabel* doubts = make_warning(this);
  doubts->setObjectName(QStringLiteral("registration_doubts"));
  box->addWidget(doubts);
  QLabel* notes = make_warning(this);
  notes->setObjectName(QStringLiteral("registration_notes"));
  box->addWidget(notes);

  auto* accept = new TaskButton(
      engine, tr("Use it nevertheless"),
      [&engine] { return engine::Command(engine::AcceptRegistration{engine.state()[part::registration]}); },
      this);
  accept->setObjectName(QStringLiteral("accept_registration"));
  accept->watch(engine::AcceptRegistration{});
  accept->button()->setProperty("role", QVariant());  // not the step that one takes in passing
  accept->setToolTip(
      tr("The registration was refused: what is known contradicts it. Its doubts stay in the "
         "picture."));
  box->addWidget(accept);

  box->addWidget(make_rival_rows(engine, model));
  box->addWidget(make_placing_rows(engine, model, placing));

  couplings_.add(model.is_refused, [accept](bool is) { accept->setVisible(is); });
  couplings_.add(model.is_being_made, [accept](bool is) {
    accept->set_obstacle(is ? RegistrationModel::wait_words() : QString());
  });
  couplings_.add(model.is_unchecked, [unchecked](bool is) { unchecked->setVisible(is); });
  couplings_.add(model.figures, [figures](const FigureRows& rows) { figures->set_rows(rows); });
  couplings_.add(model.doubts, [doubts](const QString& text) { show_warning(*doubts, text); });
  couplings_.add(model.notes, [notes](const QString& text) { show_warning(*notes, text); });
}

QLayout* RegistrationBox::make_method_row(RegistrationModel& model) {
  struct Choice {
    registration::Method method;
    QString name, what;
  };
  const std::array<Choice, 4> choices = {
      {{registration::Method::automatic, tr("Automatic"),
        tr("Few forces of tools where they are worth it, else springs; both from the most probable shape")},
       {registration::Method::forces, tr("Contact forces"),
        tr("Few forces on the surface, under the elastic law that is most probable")},
       {registration::Method::springs, tr("Springs"),
        tr("Springs from the most probable shape to the points")},
       {registration::Method::paper, tr("As published"),
        tr("Springs alone, without simulated operations: to compare with")}}};
  auto* row = new QHBoxLayout;
  row->addWidget(new QLabel(tr("Shape by"), this));
  QComboBox* combo = make_narrow_combo(this);
  combo->setObjectName(QStringLiteral("registration_method"));
  for (const Choice& choice : choices) {
    combo->addItem(choice.name, static_cast<int>(choice.method));
    combo->setItemData(combo->count() - 1, choice.what, Qt::ToolTipRole);
  }
  row->addWidget(combo, 1);
  connect(combo, &QComboBox::activated, this, [&model, combo](int index) {
    model.method = static_cast<registration::Method>(combo->itemData(index).toInt());
  });
  couplings_.add(model.method, [combo](registration::Method method) {
    combo->setCurrentIndex(combo->findData(static_cast<int>(method)));
    combo->setToolTip(combo->itemData(combo->currentIndex(), Qt::ToolTipRole).toString());
  });
  return row;
}

QWidget* RegistrationBox::make_undo(RegistrationModel& model) {
  auto* undo = new QPushButton(tr("Former registration"), this);
  undo->setObjectName(QStringLiteral("undo_registration"));
  undo->setToolTip(
      tr("Back to the registration before this one, and forth again (Ctrl+Z before anything is "
         "tracked). It is kept with the case."));
  connect(undo, &QPushButton::clicked, &model, &RegistrationModel::undo);
  couplings_.add(model.has_former, [undo](bool has) { undo->setVisible(has); });
  couplings_.add(model.can_undo, [undo](bool can) { undo->setEnabled(can); });  // nothing below it moves
  return undo;
}

QWidget* RegistrationBox::make_rival_rows(EngineBridge& engine, RegistrationModel& model) {
  auto* rows = new QWidget(this);
  rows->setObjectName(QStringLiteral("rivals"));
  QVBoxLayout* layout = make_box_layout(rows);
  layout->addWidget(
      make_explanation(tr("The organ may be elsewhere. Look at the other places over the picture "
                          "and in 3D before going on."),
                       rows));
  layout->addWidget(new RivalPictures(engine, model, rows));
  QComboBox* choice = make_narrow_combo(rows);
  choice->setObjectName(QStringLiteral("rival"));
  layout->addWidget(choice);
  auto* use = new TaskButton(
      engine, tr("Use this place"),
      [&engine, &model]() -> std::optional<engine::Command> {
        if (model.shown_rival < 0) return {};
        return engine::Command(engine::ChooseRival{static_cast<std::size_t>(model.shown_rival.value()),
                                                   engine.state()[part::registration]});
      },
      rows);
  use->setObjectName(QStringLiteral("choose_rival"));
  use->watch(engine::ChooseRival{});
  use->button()->setProperty("role", QVariant());
  layout->addWidget(use);
  connect(choice, &QComboBox::activated, rows, [&model](int index) { model.shown_rival = index - 1; });
  couplings_.add(model.rivals, [rows, choice](const QStringList& lines) {
    choice->clear();
    choice->addItem(tr("As registered"));
    choice->addItems(lines);
    rows->setVisible(!lines.isEmpty());
  });
  const auto show_obstacle = [use, &model] {
    use->set_obstacle(model.is_being_made     ? RegistrationModel::wait_words()
                      : model.shown_rival < 0 ? tr("Choose another place above to compare.")
                                              : QString());
  };
  couplings_.add(model.shown_rival, [choice, show_obstacle](int rival) {
    choice->setCurrentIndex(rival + 1);
    show_obstacle();
  });
  couplings_.add(model.is_being_made, [show_obstacle](bool) { show_obstacle(); });
  return rows;
}

QWidget* RegistrationBox::make_placing_rows(EngineBridge& engine, RegistrationModel& model,
                                            PlacingModel& placing) {
  auto* rows = new QWidget(this);
  QVBoxLayout* layout = make_box_layout(rows);
  auto* hold = new QPushButton(rows);
  hold->setObjectName(QStringLiteral("place_by_hand"));
  layout->addWidget(hold);
  QLabel* how = make_explanation(tr("Drag the organ over the picture; with Shift it turns, with Ctrl it "
                                    "rolls, the wheel brings it nearer. "
                                    "Refine when its outline lies about right."),
                                 rows);
  layout->addWidget(how);
  auto* refine = new TaskButton(
      engine, tr("Refine from here"),
      [&model, &placing]() -> std::optional<engine::Command> {
        if (!placing.is_placing) return {};
        engine::Register command;
        command.method = model.method;
        command.start = engine::Register::Start::near;
        command.given = placing.pose();
        return engine::Command(command);
      },
      rows);
  refine->setObjectName(QStringLiteral("refine"));
  refine->watch(engine::Register{});
  layout->addWidget(refine);
  connect(hold, &QPushButton::clicked, rows, [&placing] {
    if (placing.is_placing)
      placing.stop();
    else
      placing.start();
  });
  connect(refine, &TaskButton::done, &placing, [&placing](const engine::Outcome& outcome) {
    if (outcome.status == engine::Status::done) placing.stop();
  });
  couplings_.add(placing.is_placing, [hold, how, refine](bool is) {
    hold->setText(is ? tr("Put it back") : tr("Place by hand"));
    how->setVisible(is);
    refine->setVisible(is);
  });
  couplings_.add(placing.obstacle, [hold](const QString& text) {
    hold->setEnabled(text.isEmpty());
    hold->setToolTip(
        text.isEmpty() ? tr("Where the rigid start goes wrong: hold the organ before the picture.") : text);
  });
  return rows;
}

}  // namespace glisson::ui
