// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "glisson/ui/common/couplings.h"
#include "glisson/ui/guidance/moments_model.h"

class QLineEdit;
class QListWidget;
class QPushButton;

namespace glisson::ui {

/// Keeps the moment on the screen, and lists those that were kept: a click shows one, another one goes back
/// to live.
class MomentsBox : public QWidget {
  Q_OBJECT
 public:
  /// @param model outlives the box.
  explicit MomentsBox(MomentsModel& model, QWidget* parent = nullptr);

 private:
  void show_rows();
  /// Another case: neither the choice nor a text that nobody has entered yet is of it.
  void forget();
  /// Number of the chosen row; 0: none.
  int chosen() const;
  void show_choice();

  MomentsModel& model_;
  QListWidget* list_;
  QLineEdit* title_;
  QPushButton* remove_;
  Couplings couplings_;
};

}  // namespace glisson::ui
