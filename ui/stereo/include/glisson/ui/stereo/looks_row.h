// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "glisson/ui/common/engine_bridge.h"

class QLabel;
class QPushButton;

namespace glisson::ui {

/// Earlier looks at the organ that the registration joins to the cloud: keeps the cloud as one, forgets them.
class LooksRow : public QWidget {
  Q_OBJECT
 public:
  explicit LooksRow(EngineBridge& engine, QWidget* parent = nullptr);

 private:
  void show_case();

  EngineBridge& engine_;
  QPushButton* keep_;
  QPushButton* forget_;
  QLabel* said_;
};

}  // namespace glisson::ui
