// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <vector>

#include "glisson/ui/common/panel.h"

class QButtonGroup;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace glisson::ui {

/// The five modules as steps, with how each stands.
class StepBar : public QWidget {
  Q_OBJECT
 public:
  explicit StepBar(QWidget* parent = nullptr);
  void add_step(const QString& name, const QString& icon);
  void set_state(int step, StepState state);
  void set_current(int step);
  QPushButton* button(int step) const { return buttons_[static_cast<std::size_t>(step)]; }

 signals:
  void chosen(int step);

 private:
  QVBoxLayout* layout_;
  QButtonGroup* group_;
  std::vector<QPushButton*> buttons_;
  std::vector<QLabel*> states_;
};

}  // namespace glisson::ui
