// SPDX-License-Identifier: GPL-3.0-or-later
#include "overlay_annotations.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPainterPath>

#include "glisson/patient/label_map.h"
#include "glisson/ui/scene/colours.h"
#include "glisson/ui/scene/picture_image.h"

namespace glisson::scene {
namespace {

/// Context of the words on the picture for translators.
class Overlay {
  Q_DECLARE_TR_FUNCTIONS(Overlay)
 public:
  static QString reason(Validity validity) {
    switch (validity) {
      case Validity::valid:
        return tr("registered");
      case Validity::not_started:
        return tr("not registered yet");
      case Validity::too_few_points:
        return tr("too few points are tracked");
      case Validity::inconsistent_motion:
        return tr("the tracked points contradict one another");
      case Validity::residual_too_large:
        return tr("the model does not fit what the camera sees");
      case Validity::mechanics_failed:
        return tr("the mechanical computation failed");
      case Validity::stale:
        return tr("an earlier step has changed since the registration");
      case Validity::surface_apart:
        return tr("the camera sees the organ elsewhere; register again");
      case Validity::picture_stands:
        return tr("the picture stands still; check the camera");
      case Validity::views_apart:
        return tr("the two views do not show the same moment; check the cameras");
      case Validity::partly_covered:
        return tr("part of the organ is covered");
      case Validity::poor_picture:
        return tr("the picture has lost light or contrast");
    }
    return {};
  }
  static QString limit(Validity validity) {
    const bool withdrawn = level_of(validity) == Level::withdrawn;
    return (withdrawn ? tr("No overlay: %1") : tr("Outline and lesions only: %1")).arg(reason(validity));
  }
  static QString frame(int index) { return tr("frame %1").arg(index); }
  static QString age(double seconds) { return tr("age %1 ms").arg(qRound(1e3 * seconds)); }
  static QString rate(double per_second) { return tr("%1 fps").arg(per_second, 0, 'f', 1); }
  static QString residual(double metres) { return tr("residual %1 mm").arg(1e3 * metres, 0, 'f', 1); }
  static QString doubtful() { return tr("Registration in doubt"); }
  static QString unchecked() { return tr("Model not checked"); }
  static QString research() { return tr("Research software: not for clinical use"); }
  static QString structure(Label label) {
    if (label == structure::kPortalVein) return tr("Portal vein");
    if (label == structure::kHepaticVeins) return tr("Hepatic veins");
    if (label == structure::kArtery) return tr("Hepatic artery");
    return tr("Lesion");
  }
};

const QColor kAmber(255, 176, 0);

/// Red where the method has lost the organ, amber where it waits, must be run again or knows less.
QColor border_colour(Validity validity) {
  const bool waits = validity == Validity::not_started || validity == Validity::stale ||
                     validity == Validity::too_few_points || level_of(validity) == Level::degraded;
  return waits ? kAmber : QColor(229, 57, 53);
}

/// Sizes that follow the picture's.
struct Layout {
  explicit Layout(const QImage& image)
      : size(image.size()),
        text(std::max(9, image.height() / 42)),
        margin(std::max(6, image.height() / 60)) {}
  QSize size;
  int text, margin;
  QFont font(bool bold = false, double scale = 1.0) const {
    QFont chosen(QStringLiteral("DejaVu Sans"));
    chosen.setStyleHint(QFont::SansSerif);
    chosen.setPixelSize(std::max(8, static_cast<int>(text * scale)));
    chosen.setBold(bold);
    return chosen;
  }
};

void draw_plate(QPainter& painter, const QRectF& box) {
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(12, 16, 20, 190));
  painter.drawRoundedRect(box, 4.0, 4.0);
}

/// Text on a dark plate; `anchor` is one of the picture's corners.
void draw_text(QPainter& painter, const Layout& layout, const QString& text, const QFont& font,
               const QColor& colour, Qt::Alignment anchor) {
  const QFontMetrics metrics(font);
  const int pad = layout.margin / 2;
  QRect box(0, 0, metrics.horizontalAdvance(text) + 2 * pad, metrics.height() + pad);
  box.moveLeft(anchor & Qt::AlignRight     ? layout.size.width() - layout.margin - box.width()
               : anchor & Qt::AlignHCenter ? (layout.size.width() - box.width()) / 2
                                           : layout.margin);
  box.moveTop(anchor & Qt::AlignBottom ? layout.size.height() - layout.margin - box.height() : layout.margin);
  draw_plate(painter, box);
  painter.setFont(font);
  painter.setPen(colour);
  painter.drawText(box, Qt::AlignCenter, text);
}

void draw_legend(QPainter& painter, const Layout& layout, const std::vector<Label>& structures) {
  std::vector<Label> entries;
  bool lesion = false;
  for (const Label label : structures) {
    if (is_lesion(label) && lesion) continue;  // one entry for all of them
    lesion = lesion || is_lesion(label);
    entries.push_back(label);
  }
  if (entries.empty()) return;
  const QFont font = layout.font();
  const QFontMetrics metrics(font);
  const int row = metrics.height() + 2, swatch = 2 * layout.text, pad = layout.margin / 2;
  int widest = 0;
  for (const Label label : entries)
    widest = std::max(widest, metrics.horizontalAdvance(Overlay::structure(label)));
  const int height = row * static_cast<int>(entries.size()) + 2 * pad;
  const QRect box(layout.margin, layout.size.height() - layout.margin - height, widest + swatch + 3 * pad,
                  height);
  draw_plate(painter, box);
  painter.setFont(font);
  int top = box.top() + pad;
  for (const Label label : entries) {
    const QRect mark(box.left() + pad, top + row / 4, swatch, row / 2);
    painter.setPen(QPen(colour_of(label), 2));
    const Qt::BrushStyle brush = is_lesion(label)                    ? Qt::FDiagPattern
                                 : label == structure::kHepaticVeins ? Qt::BDiagPattern
                                                                     : Qt::SolidPattern;
    painter.setBrush(QBrush(colour_of(label), brush));
    painter.drawRect(mark);
    painter.setPen(QColor(235, 238, 240));
    painter.drawText(QRect(mark.right() + pad, top, widest + pad, row), Qt::AlignVCenter,
                     Overlay::structure(label));
    top += row;
  }
}

void draw_margin(QPainter& painter, const Layout& layout, const std::vector<Eigen::Vector2d>& margin) {
  if (margin.size() < 2) return;
  QPainterPath path(QPointF(margin.front().x() + 0.5, margin.front().y() + 0.5));
  for (const Eigen::Vector2d& p : margin) path.lineTo(p.x() + 0.5, p.y() + 0.5);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(QColor(0, 0, 0, 120), layout.text / 4.0 + 1.5, Qt::DashLine));
  painter.drawPath(path);
  painter.setPen(QPen(QColor(240, 240, 240, 210), layout.text / 4.0, Qt::DashLine));
  painter.drawPath(path);
}

void draw_limit(QPainter& painter, const Layout& layout, Validity validity) {
  const QColor colour = border_colour(validity);
  const int thickness = std::max(4, layout.size.height() / 90);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(colour, thickness, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
  painter.drawRect(QRectF(thickness / 2.0, thickness / 2.0, layout.size.width() - thickness,
                          layout.size.height() - thickness));
  const QFont font = layout.font(true, 1.25);
  const QString text = Overlay::limit(validity);
  // Why there is less than an overlay, or none, must be read whole: in a narrow picture it takes several
  // lines.
  const QRect room(0, 0, layout.size.width() - 8 * layout.margin, layout.size.height());
  const QRect words = QFontMetrics(font).boundingRect(room, Qt::AlignCenter | Qt::TextWordWrap, text);
  QRect box(0, 0, words.width() + 4 * layout.margin, words.height() + 2 * layout.margin);
  box.moveCenter(QPoint(layout.size.width() / 2, 0));
  box.moveTop(std::max(layout.size.height() / 6 - box.height() / 2, 4 * layout.margin));
  draw_plate(painter, box);
  painter.setFont(font);
  painter.setPen(colour);
  painter.drawText(box.adjusted(layout.margin, 0, -layout.margin, 0), Qt::AlignCenter | Qt::TextWordWrap,
                   text);
}

}  // namespace

Picture annotate(const Picture& picture, const OverlayFrame& overlay, const Annotations& annotations,
                 const OverlayStyle& style, const OverlayStatus& status) {
  QImage image = copy_to_image(picture);
  const Layout layout(image);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  const bool drawn = overlay.level() != Level::withdrawn;
  if (drawn) {
    if (style.anterior_margin) draw_margin(painter, layout, annotations.margin);
    if (style.legend) draw_legend(painter, layout, annotations.structures);
    QStringList doubts;
    if (overlay.doubtful) doubts << Overlay::doubtful();
    if (status.model_unchecked) doubts << Overlay::unchecked();
    if (!doubts.isEmpty())
      draw_text(painter, layout, doubts.join(QStringLiteral("  ·  ")), layout.font(true), kAmber,
                Qt::AlignRight | Qt::AlignTop);
  }
  if (overlay.level() != Level::valid) draw_limit(painter, layout, overlay.validity);
  if (style.status) {
    QStringList words{Overlay::frame(overlay.index)};
    if (status.age_seconds > 0.0) words << Overlay::age(status.age_seconds);
    if (status.frames_per_second > 0.0) words << Overlay::rate(status.frames_per_second);
    if (drawn) words << Overlay::residual(overlay.residual);
    draw_text(painter, layout, words.join(QStringLiteral("  ·  ")), layout.font(), QColor(225, 230, 233),
              Qt::AlignLeft | Qt::AlignTop);
    draw_text(painter, layout, Overlay::research(), layout.font(false, 0.8), QColor(190, 197, 202),
              Qt::AlignRight | Qt::AlignBottom);
  }
  painter.end();
  return to_picture(image);
}

std::string validity_text(Validity validity) { return Overlay::reason(validity).toStdString(); }

}  // namespace glisson::scene
