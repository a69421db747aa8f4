// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/common/figures_table.h"

#include <QGridLayout>
#include <QLabel>

namespace glisson::ui {

FiguresTable::FiguresTable(QWidget* parent) : QWidget(parent), grid_(new QGridLayout(this)) {
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setHorizontalSpacing(10);
  grid_->setVerticalSpacing(3);
  grid_->setColumnStretch(0, 1);
  setVisible(false);
}

void FiguresTable::set_rows(const FigureRows& rows) {
  // Labels are used again: live figures change many times a second and would flicker.
  while (rows_.size() > rows.size()) {
    delete rows_.back().first;
    delete rows_.back().second;
    rows_.pop_back();
  }
  while (rows_.size() < rows.size()) {
    auto* left = new QLabel(this);
    left->setProperty("role", "figure-name");
    left->setWordWrap(true);
    auto* right = new QLabel(this);
    right->setProperty("role", "figure-value");
    right->setTextInteractionFlags(Qt::TextSelectableByMouse);
    right->setAlignment(Qt::AlignRight | Qt::AlignTop);
    // Live figures grow and shrink: the column does not follow each of them.
    right->setMinimumWidth(right->fontMetrics().horizontalAdvance(QStringLiteral("0000.0 ms")));
    const int line = static_cast<int>(rows_.size());
    grid_->addWidget(left, line, 0);
    grid_->addWidget(right, line, 1);
    rows_.emplace_back(left, right);
  }
  for (std::size_t line = 0; line < rows.size(); ++line) {
    rows_[line].first->setText(rows[line].first);
    rows_[line].second->setText(rows[line].second);
  }
  setVisible(!rows.empty());
}

}  // namespace glisson::ui
