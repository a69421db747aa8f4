// SPDX-License-Identifier: GPL-3.0-or-later
#include "step_bar.h"

#include <QButtonGroup>
#include <QGridLayout>
#include <QIcon>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace glisson::ui {

StepBar::StepBar(QWidget* parent)
    : QWidget(parent), layout_(new QVBoxLayout(this)), group_(new QButtonGroup(this)) {
  setObjectName(QStringLiteral("step_bar"));
  setAttribute(Qt::WA_StyledBackground);
  setFixedWidth(184);
  layout_->setContentsMargins(0, 10, 0, 10);
  layout_->setSpacing(0);
  layout_->addStretch(1);
  group_->setExclusive(true);
  auto* note = make_explanation(tr("Research software: not for clinical use"), this);
  note->setContentsMargins(14, 0, 10, 0);
  layout_->addWidget(note);
  connect(group_, &QButtonGroup::idClicked, this, &StepBar::chosen);
}

void StepBar::add_step(const QString& name, const QString& icon) {
  const int step = static_cast<int>(buttons_.size());
  auto* button = new QPushButton(this);
  button->setCheckable(true);
  button->setProperty("role", "step");
  button->setShortcut(QKeySequence(Qt::CTRL | static_cast<Qt::Key>(Qt::Key_1 + step)));
  button->setToolTip(tr("Ctrl+%1").arg(step + 1));
  button->setAccessibleName(name);
  button->setObjectName(QStringLiteral("step_%1").arg(step));
  button->setFixedHeight(64);
  auto* grid = new QGridLayout(button);
  grid->setContentsMargins(14, 8, 8, 8);
  grid->setHorizontalSpacing(12);
  grid->setVerticalSpacing(1);
  auto* mark = new QLabel(button);
  mark->setPixmap(QIcon(icon).pixmap(26, 26));
  auto* title = new QLabel(name, button);
  title->setProperty("role", "step-name");
  auto* state = new QLabel(button);
  state->setProperty("role", "step-state");
  for (QLabel* label : {mark, title, state}) label->setAttribute(Qt::WA_TransparentForMouseEvents);
  grid->addWidget(mark, 0, 0, 2, 1);
  grid->addWidget(title, 0, 1, Qt::AlignBottom);
  grid->addWidget(state, 1, 1, Qt::AlignTop);
  grid->setColumnStretch(1, 1);
  group_->addButton(button, step);
  layout_->insertWidget(step, button);
  buttons_.push_back(button);
  states_.push_back(state);
  set_state(step, StepState::waiting);
}

void StepBar::set_state(int step, StepState state) {
  QLabel* label = states_[static_cast<std::size_t>(step)];
  switch (state) {
    case StepState::waiting:
      label->setText(tr("not done"));
      set_style_property(label, "state", "waiting");
      break;
    case StepState::to_review:
      label->setText(tr("? to be reviewed"));
      set_style_property(label, "state", "to-review");
      break;
    case StepState::done:
      label->setText(tr("✓ up to date"));
      set_style_property(label, "state", "done");
      break;
    case StepState::stale:
      label->setText(tr("! out of date"));
      set_style_property(label, "state", "stale");
      break;
    case StepState::refused:
      label->setText(tr("✕ refused"));
      set_style_property(label, "state", "refused");
      break;
    case StepState::running:
      label->setText(tr("running…"));
      set_style_property(label, "state", "running");
      break;
  }
}

void StepBar::set_current(int step) { buttons_[static_cast<std::size_t>(step)]->setChecked(true); }

}  // namespace glisson::ui
