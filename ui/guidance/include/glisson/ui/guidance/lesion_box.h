// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "glisson/ui/common/couplings.h"
#include "glisson/ui/guidance/live_view_model.h"

class QLabel;
class QTreeWidget;

namespace glisson::ui {

/// What is known of each lesion in the picture, a row each, and why less than a lesion is drawn; the numbers
/// of the one that is chosen, here or in the picture.
class LesionBox : public QWidget {
  Q_OBJECT
 public:
  /// @param model outlives the box.
  explicit LesionBox(LiveViewModel& model, QWidget* parent = nullptr);

 private:
  enum Column { name, state, within, columns };
  void show_rows(const LesionRows& rows);
  void show_choice(Label lesion);

  QTreeWidget* table_;
  QLabel* why_;
  LiveViewModel& model_;
  Couplings couplings_;
};

}  // namespace glisson::ui
