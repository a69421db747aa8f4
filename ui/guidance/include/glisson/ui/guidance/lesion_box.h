// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "glisson/ui/common/couplings.h"
#include "glisson/ui/guidance/live_view_model.h"
#include "glisson/ui/guidance/registration_model.h"

class QLabel;
class QTreeWidget;
class QTreeWidgetItem;

namespace glisson::ui {

/// What is known of each lesion in the picture, a row each, and why less than a lesion is drawn; the numbers
/// of the one that is chosen, here or in the picture. Below them the largest vessel forks, as the
/// registration expects their error; none below a kept moment.
class LesionBox : public QWidget {
  Q_OBJECT
 public:
  /// Both outlive the box.
  LesionBox(LiveViewModel& model, RegistrationModel& registration, QWidget* parent = nullptr);

 private:
  enum Column { name, state, expected, within, columns };
  void show_rows();
  /// The picture on the screen is a kept moment's.
  bool shows_kept() const;
  void show_row(QTreeWidgetItem* item, const LesionRow& row, const SpotRow& spot) const;
  void show_choice(Label lesion);

  QTreeWidget* table_;
  QLabel* why_;
  LiveViewModel& model_;
  RegistrationModel& registration_;
  Couplings couplings_;
};

}  // namespace glisson::ui
