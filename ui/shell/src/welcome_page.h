// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace glisson::ui {

/// What stands in the middle before anything is open.
class WelcomePage : public QWidget {
  Q_OBJECT
 public:
  explicit WelcomePage(QWidget* parent = nullptr);

 signals:
  void open_case();
  void open_dicom();
  void open_volume();
};

}  // namespace glisson::ui
