// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineF>
#include <QPainter>
#include <optional>

namespace glisson::ui {

/// A measure's line with its ends, the line across it if there is one, and its number beside it, within the
/// view.
void paint_measure(QPainter& painter, const QRectF& view, const QLineF& line,
                   const std::optional<QLineF>& across, const QString& number);

}  // namespace glisson::ui
