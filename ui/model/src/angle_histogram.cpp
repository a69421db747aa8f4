// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/model/angle_histogram.h"

#include <QPainter>
#include <algorithm>

namespace glisson::ui {

AngleHistogram::AngleHistogram(QWidget* parent) : QWidget(parent) {
  setFixedHeight(64);
  setToolTip(
      tr("Angles between the faces of each element. Flat elements, below 10°, make the computation "
         "inexact."));
}

void AngleHistogram::set_counts(const std::array<int, model::kDihedralBins>& counts) {
  counts_ = counts;
  setAccessibleName(tr("Dihedral angles, %1 below 10°").arg(counts_[0]));
  update();
}

void AngleHistogram::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const int most = std::max(1, *std::max_element(counts_.begin(), counts_.end()));
  const double step = static_cast<double>(width()) / model::kDihedralBins;
  const int foot = height() - 16;
  for (int i = 0; i < model::kDihedralBins; ++i) {
    const int count = counts_[static_cast<std::size_t>(i)];
    if (count == 0) continue;
    const double high = std::max(1.0, static_cast<double>(foot - 2) * count / most);
    painter.fillRect(QRectF(i * step + 1.0, foot - high, step - 2.0, high),
                     i == 0 ? QColor(230, 110, 50) : QColor(110, 160, 200));
  }
  painter.setPen(palette().color(QPalette::Disabled, QPalette::WindowText));
  painter.drawLine(0, foot, width(), foot);
  for (const int degrees : {0, 90, 180}) {
    const QRectF place(degrees * (width() - 40.0) / 180.0, foot + 1.0, 40.0, 15.0);
    painter.drawText(place,
                     degrees == 0    ? Qt::AlignLeft
                     : degrees == 90 ? Qt::AlignHCenter
                                     : Qt::AlignRight,
                     tr("%1°").arg(degrees));
  }
}

}  // namespace glisson::ui
