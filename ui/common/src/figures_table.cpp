// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/common/figures_table.h"

#include <QGridLayout>
#include <QLabel>

#include "glisson/ui/common/texts.h"

namespace glisson::ui {

FiguresTable::FiguresTable(QWidget* parent) : QWidget(parent), grid_(new QGridLayout(this)) {
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setHorizontalSpacing(10);
  grid_->setVerticalSpacing(3);
  grid_->setColumnStretch(0, 1);
  setVisible(false);
}

void FiguresTable::set_rows(const std::vector<std::pair<QString, QString>>& rows) {
  while (QLayoutItem* item = grid_->takeAt(0)) {
    delete item->widget();
    delete item;
  }
  int line = 0;
  for (const auto& [name, value] : rows) {
    auto* left = new QLabel(name, this);
    left->setProperty("role", "figure-name");
    left->setWordWrap(true);
    auto* right = new QLabel(value, this);
    right->setProperty("role", "figure-value");
    right->setTextInteractionFlags(Qt::TextSelectableByMouse);
    grid_->addWidget(left, line, 0);
    grid_->addWidget(right, line, 1, Qt::AlignRight | Qt::AlignTop);
    ++line;
  }
  setVisible(!rows.empty());
}

void FiguresTable::set_figures(const Figures& figures) {
  std::vector<std::pair<QString, QString>> rows;
  for (const auto& [key, value] : figures) rows.emplace_back(figure_name(key), figure_value(key, value));
  set_rows(rows);
}

}  // namespace glisson::ui
