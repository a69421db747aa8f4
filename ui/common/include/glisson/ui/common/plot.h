// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QPointF>
#include <QString>
#include <QStringList>
#include <vector>

/// @file
/// Plots for pages: bars by category or lines, side by side in one picture. Needs Qt's fonts, no display.

namespace glisson::ui {

struct PlotSeries {
  QString name;
  std::vector<QPointF> values;  ///< lines: x, y; bars: x is the category's number. A y below 0: nothing there
  std::vector<double> low, high;  ///< the values' spread, or empty
};

struct Plot {
  QString title, x, y;     ///< axes with units
  QStringList categories;  ///< bars, if there are any
  std::vector<PlotSeries> series;
};

/// One picture with all plots in a row; Okabe and Ito's colours, a legend in each.
QImage draw_plots(const std::vector<Plot>& plots);

}  // namespace glisson::ui
