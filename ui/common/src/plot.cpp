// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/common/plot.h"

#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>

namespace glisson::ui {
namespace {

constexpr int kHeight = 620;  // pixels
constexpr int kManyCategories = 8;
constexpr int kLeft = 90, kRight = 30, kTop = 96, kBottom = 110;
/// Okabe and Ito 2008: told apart by people who do not tell red from green.
constexpr std::array<QRgb, 4> kColours = {0xFFD55E00, 0xFF009E73, 0xFF0072B2, 0xFFE69F00};

/// 1, 2 or 5 times a power of ten, at most some six to the top.
double tick_step(double top) {
  const double rough = top / 6.0, power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double step : {1.0, 2.0, 5.0})
    if (step * power >= rough) return step * power;
  return 10.0 * power;
}

bool is_wide(const Plot& plot) { return plot.categories.size() > kManyCategories; }
int width_of(const Plot& plot) { return is_wide(plot) ? 1700 : 900; }

class Painting {
 public:
  Painting(QPainter& painter, const Plot& plot) : painter_(painter), plot_(plot), width_(width_of(plot)) {
    for (const PlotSeries& series : plot.series) {
      for (const QPointF& value : series.values) {
        top_ = std::max(top_, value.y());
        right_ = std::max(right_, value.x());
      }
      for (const double high : series.high) top_ = std::max(top_, high);
    }
    if (top_ <= 0.0) top_ = 1.0;
    if (right_ <= 0.0) right_ = 1.0;
    top_ *= 1.08;
    if (!plot.categories.isEmpty()) right_ = static_cast<double>(plot.categories.size());
  }

  void draw() {
    draw_axes();
    draw_titles();
    for (std::size_t i = 0; i < plot_.series.size(); ++i) {
      painter_.setPen(QPen(QColor(kColours[i % kColours.size()]), 2.5));
      painter_.setBrush(QColor(kColours[i % kColours.size()]));
      plot_.categories.isEmpty() ? draw_line(plot_.series[i]) : draw_bars(plot_.series[i], i);
    }
  }

 private:
  double x_at(double fraction) const { return kLeft + fraction * (width_ - kLeft - kRight); }
  QPointF at(double x, double y) const {
    return {x_at(x / right_), kHeight - kBottom - y / top_ * (kHeight - kTop - kBottom)};
  }

  void draw_axes() {
    const double step = tick_step(top_);
    for (double y = 0.0; y <= top_; y += step) {
      painter_.setPen(QColor(0xDD, 0xDD, 0xDD));
      painter_.drawLine(at(0.0, y), at(right_, y));
      painter_.setPen(Qt::black);
      painter_.drawText(QRectF(0, at(0.0, y).y() - 12, kLeft - 10, 24), Qt::AlignRight | Qt::AlignVCenter,
                        QString::number(y));
    }
    painter_.setPen(QPen(Qt::black, 1.5));
    painter_.drawLine(at(0.0, 0.0), at(right_, 0.0));
    painter_.drawLine(at(0.0, 0.0), at(0.0, top_));
    if (!plot_.categories.isEmpty()) return draw_categories();
    const double along = tick_step(right_);
    for (double x = 0.0; x <= right_; x += along)
      painter_.drawText(QRectF(at(x, 0.0).x() - 40, kHeight - kBottom + 8, 80, 24), Qt::AlignCenter,
                        QString::number(x));
  }

  /// Many names stand on their side.
  void draw_categories() {
    const bool many = is_wide(plot_);
    for (qsizetype i = 0; i < plot_.categories.size(); ++i) {
      painter_.save();
      painter_.translate(at(static_cast<double>(i) + 0.5, 0.0) + QPointF(0, 10));
      if (many) painter_.rotate(-45.0);
      painter_.drawText(many ? QRectF(-130, -8, 130, 24) : QRectF(-60, 0, 120, 24),
                        many ? Qt::AlignRight | Qt::AlignVCenter : Qt::AlignCenter, plot_.categories[i]);
      painter_.restore();
    }
  }

  void draw_titles() {
    painter_.setPen(Qt::black);
    painter_.drawText(QRectF(0, 8, width_, 32), Qt::AlignCenter, plot_.title);
    painter_.drawText(QRectF(kLeft, kHeight - 36, width_ - kLeft - kRight, 28), Qt::AlignCenter, plot_.x);
    painter_.save();
    painter_.translate(24.0, 0.5 * kHeight);
    painter_.rotate(-90.0);
    painter_.drawText(QRectF(-250, -16, 500, 32), Qt::AlignCenter, plot_.y);
    painter_.restore();
    double x = kLeft + 10;
    for (std::size_t i = 0; i < plot_.series.size(); ++i) {
      painter_.fillRect(QRectF(x, 56, 22, 14), QColor(kColours[i % kColours.size()]));
      painter_.drawText(QPointF(x + 30, 70), plot_.series[i].name);
      x += 60 + painter_.fontMetrics().horizontalAdvance(plot_.series[i].name);
    }
  }

  void draw_spread(const PlotSeries& series, std::size_t i, double x) {
    if (i >= series.low.size() || series.values[i].y() < 0.0) return;
    const QPointF low = at(x, series.low[i]), high = at(x, series.high[i]);
    painter_.drawLine(low, high);
    for (const QPointF& end : {low, high}) painter_.drawLine(end - QPointF(5, 0), end + QPointF(5, 0));
  }

  void draw_line(const PlotSeries& series) {
    QPolygonF line;
    for (std::size_t i = 0; i < series.values.size(); ++i) {
      const QPointF& value = series.values[i];
      if (value.y() < 0.0) continue;
      line << at(value.x(), value.y());
      painter_.drawEllipse(line.back(), 4.5, 4.5);
      draw_spread(series, i, value.x());
    }
    painter_.drawPolyline(line);
  }

  void draw_bars(const PlotSeries& series, std::size_t number) {
    const double width = 0.8 / static_cast<double>(plot_.series.size());
    for (std::size_t i = 0; i < series.values.size(); ++i) {
      const QPointF& value = series.values[i];
      if (value.y() < 0.0) continue;
      const double x = value.x() + 0.1 + width * static_cast<double>(number);
      painter_.setPen(Qt::NoPen);
      painter_.drawRect(QRectF(at(x, value.y()), at(x + 0.9 * width, 0.0)));
      painter_.setPen(QPen(Qt::black, 1.2));
      draw_spread(series, i, x + 0.45 * width);
    }
  }

  QPainter& painter_;
  const Plot& plot_;
  int width_;
  double top_ = 0.0, right_ = 0.0;
};

}  // namespace

QImage draw_plots(const std::vector<Plot>& plots) {
  int width = 0;
  for (const Plot& plot : plots) width += width_of(plot);
  QImage picture(width, kHeight, QImage::Format_RGB32);
  picture.fill(Qt::white);
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  QFont font = painter.font();
  font.setPixelSize(17);
  painter.setFont(font);
  for (const Plot& plot : plots) {
    Painting(painter, plot).draw();
    painter.translate(width_of(plot), 0);
  }
  return picture;
}

}  // namespace glisson::ui
