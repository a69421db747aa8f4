// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QVBoxLayout>

namespace glisson::ui {

/// Of a box within a panel's section: its controls stand as if they were the section's own.
inline QVBoxLayout* make_box_layout(QWidget* box) {
  auto* layout = new QVBoxLayout(box);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(5);
  return layout;
}

}  // namespace glisson::ui
