// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <vector>

namespace glisson::ui {

class TaskButton;

/// A dialog whose buttons start work. While that runs, Escape and *Close* only hide it: it comes back with
/// what is told of the work. Else they end it.
class TaskDialog : public QDialog {
  Q_OBJECT
 public:
  using QDialog::QDialog;

  void reject() override;

 protected:
  /// Before its outcome is connected to anything else.
  void come_back_for(const TaskButton& task);

 private:
  std::vector<const TaskButton*> tasks_;
};

}  // namespace glisson::ui
