// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <utility>
#include <vector>

class QGridLayout;
class QLabel;

namespace glisson::ui {

/// Names and values.
using FigureRows = std::vector<std::pair<QString, QString>>;

/// Names and values of a stage's result, two columns.
class FiguresTable : public QWidget {
  Q_OBJECT
 public:
  explicit FiguresTable(QWidget* parent = nullptr);
  void set_rows(const FigureRows& rows);
  void clear() { set_rows({}); }

 private:
  QGridLayout* grid_;
  std::vector<std::pair<QLabel*, QLabel*>> rows_;
};

}  // namespace glisson::ui
