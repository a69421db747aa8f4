// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/common/panel.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QStackedLayout>
#include <QStyle>
#include <QVBoxLayout>
#include <algorithm>

#include "glisson/engine/obstacle.h"
#include "glisson/ui/common/texts.h"
#include "glisson/ui/scene/colours.h"

namespace glisson::ui {

void set_style_property(QWidget* widget, const char* name, const QVariant& value) {
  if (widget->property(name) == value) return;
  widget->setProperty(name, value);
  widget->style()->unpolish(widget);
  widget->style()->polish(widget);
}

QIcon structure_icon(Label structure) {
  QPixmap pixmap(14, 14);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(QColor(230, 230, 230), 1));
  painter.setBrush(scene::colour_of(structure));
  painter.drawEllipse(QRectF(1.5, 1.5, 11, 11));
  painter.end();
  return pixmap;
}

QLabel* make_explanation(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setProperty("role", "explanation");
  label->setWordWrap(true);
  return label;
}

QLabel* make_warning(QWidget* parent) {
  auto* label = new QLabel(parent);
  label->setProperty("role", "warning");
  label->setWordWrap(true);
  label->hide();
  return label;
}

void show_warning(QLabel& warning, const QString& text) {
  warning.setText(text);
  warning.setVisible(!text.isEmpty());
}

QComboBox* make_narrow_combo(QWidget* parent) {
  constexpr int kLetters = 12;
  auto* box = new QComboBox(parent);
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(kLetters);
  box->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  return box;
}

Panel::Panel(EngineBridge& engine, const QString& title, const QString& purpose, QWidget* parent)
    : QWidget(parent), engine_(engine), title_(title) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(14, 12, 14, 12);
  layout->setSpacing(8);
  auto* head = new QHBoxLayout;
  auto* name = new QLabel(title, this);
  name->setProperty("role", "title");
  chip_ = new QLabel(this);
  chip_->setProperty("role", "chip");
  head->addWidget(name, 1);
  head->addWidget(chip_, 0, Qt::AlignRight | Qt::AlignVCenter);
  layout->addLayout(head);
  purpose_ = new QStackedLayout;
  purpose_->addWidget(make_explanation(purpose, this));
  layout->addLayout(purpose_);
  content_ = new QVBoxLayout;
  content_->setSpacing(8);
  layout->addLayout(content_);
  layout->addStretch(1);
  connect(&engine_, &EngineBridge::case_changed, this, &Panel::update_step_state);
  connect(&engine_, &EngineBridge::tasks_changed, this, &Panel::update_step_state);
}

QPushButton* Panel::add_attention(const QString& tip) {
  attention_ = new QPushButton(this);
  attention_->setProperty("role", "attention");
  attention_->setObjectName(QStringLiteral("attention"));
  attention_->setToolTip(tip);
  purpose_->addWidget(attention_);
  return attention_;
}

void Panel::call_attention(const QString& text) {
  attention_->setText(text);
  purpose_->setCurrentIndex(text.isEmpty() ? 0 : 1);
}

QVBoxLayout* Panel::add_section(const QString& heading, const QString& explanation) {
  auto* box = new QVBoxLayout;
  box->setSpacing(5);
  auto* label = new QLabel(heading, this);
  label->setProperty("role", "heading");
  box->addSpacing(6);
  box->addWidget(label);
  if (!explanation.isEmpty()) box->addWidget(make_explanation(explanation, this));
  content_->addLayout(box);
  return box;
}

void Panel::watch(engine::Part part, std::function<bool(const engine::CaseState&)> is_open) {
  part_ = part;
  is_open_ = std::move(is_open);
  update_step_state();
}

void Panel::update_step_state() {
  if (!part_) return;
  const engine::StageState stage = engine_.snapshot()->stage(*part_);
  const bool running = std::any_of(engine_.tasks().begin(), engine_.tasks().end(), [&](const Task& task) {
    return task.traits.writes.has(*part_) && task.traits.notice != engine::Notice::quiet;
  });
  const StepState now = running                                       ? StepState::running
                        : stage == engine::StageState::absent         ? StepState::waiting
                        : stage == engine::StageState::stale          ? StepState::stale
                        : engine::is_refused(engine_.state(), *part_) ? StepState::refused
                        : is_open_ && is_open_(engine_.state())       ? StepState::to_review
                                                                      : StepState::done;
  static constexpr std::array<const char*, 6> kNames = {"waiting", "to-review", "done",
                                                        "stale",   "refused",   "running"};
  chip_->setText(now == StepState::running     ? tr("Running")
                 : now == StepState::refused   ? tr("Refused")
                 : now == StepState::to_review ? tr("To be reviewed")
                                               : stage_state_text(stage));
  set_style_property(chip_, "state", QString::fromLatin1(kNames[static_cast<std::size_t>(now)]));
  if (now == step_state_) return;
  step_state_ = now;
  emit step_state_changed();
}

}  // namespace glisson::ui
