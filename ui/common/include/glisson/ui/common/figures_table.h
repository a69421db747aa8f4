// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <utility>
#include <vector>

#include "glisson/core/json_file.h"

class QGridLayout;

namespace glisson::ui {

/// Names and values of a stage's result, two columns.
class FiguresTable : public QWidget {
  Q_OBJECT
 public:
  explicit FiguresTable(QWidget* parent = nullptr);
  void set_rows(const std::vector<std::pair<QString, QString>>& rows);
  /// In the order of the keys, with words and units.
  void set_figures(const Figures& figures);
  void clear() { set_rows({}); }

 private:
  QGridLayout* grid_;
};

}  // namespace glisson::ui
