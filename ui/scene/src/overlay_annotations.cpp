// SPDX-License-Identifier: GPL-3.0-or-later
#include "overlay_annotations.h"

#include <QPainter>

#include "dashes.h"
#include "glisson/patient/label_map.h"
#include "glisson/ui/scene/colours.h"
#include "overlay_layout.h"
#include "overlay_words.h"

namespace glisson::scene {
namespace {

/// Red where the method has lost the organ, amber where it waits, must be run again or knows less.
QColor border_colour(Validity validity, bool refused) {
  const bool waits = validity == Validity::not_started || validity == Validity::stale ||
                     validity == Validity::too_few_points || validity == Validity::picture_lost ||
                     level_of(validity) == Level::degraded;
  return waits && !refused ? kAmber : QColor(229, 57, 53);
}

void draw_legend(QPainter& painter, const Layout& layout, Taken& taken,
                 const std::vector<Label>& structures) {
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
  taken.add(box);
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
  QPolygonF line;
  for (const Eigen::Vector2d& p : margin) line << QPointF(p.x() + 0.5, p.y() + 0.5);
  draw_dashes(painter, line, false,
              {.colour = QColor(240, 240, 240, 210),
               .below = QColor(0, 0, 0, 120),
               .width = layout.text / 4.0,
               .rim = 0.75,
               .off = 2.0});
}

void draw_limit(QPainter& painter, const Layout& layout, Taken& taken, Validity validity, bool refused) {
  const QColor colour = border_colour(validity, refused);
  const int thickness = std::max(4, layout.size.height() / 90);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(colour, thickness, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
  painter.drawRect(QRectF(thickness / 2.0, thickness / 2.0, layout.size.width() - thickness,
                          layout.size.height() - thickness));
  // Why there is less than an overlay, or none, must be read whole: in a narrow picture it takes several
  // lines. What to do stands below, where the upper half of the picture has room for it.
  const QFont font = layout.font(true, 1.25), small = layout.font(true);
  const QString text = refused ? Overlay::refused() : Overlay::limit(validity);
  const QString remedy = refused ? Overlay::remedy_of_refused() : Overlay::remedy(validity);
  const QRect room(0, 0, layout.size.width() - 8 * layout.margin, layout.size.height());
  const QRect words = QFontMetrics(font).boundingRect(room, Qt::AlignCenter | Qt::TextWordWrap, text);
  QRect more = QFontMetrics(small).boundingRect(room, Qt::AlignCenter | Qt::TextWordWrap, remedy);
  const int height = words.height() + 2 * layout.margin;
  const int half = height / 2;
  const double top = std::max(layout.size.height() / 6.0 - half, 4.0 * layout.margin);
  if (top + height + more.height() > 0.45 * layout.size.height()) more = QRect();
  QRectF box(0, 0, std::max(words.width(), more.width()) + 4 * layout.margin, height + more.height());
  box.moveLeft((layout.size.width() - box.width()) / 2);
  box.moveTop(top);
  box = taken.below(box);
  draw_plate(painter, box);
  const QRectF inside = box.adjusted(layout.margin, layout.margin, -layout.margin, -layout.margin);
  painter.setFont(font);
  painter.setPen(colour);
  painter.drawText(inside.adjusted(0, 0, 0, -more.height()), Qt::AlignCenter | Qt::TextWordWrap, text);
  if (more.isEmpty()) return;
  painter.setFont(small);
  painter.setPen(kWords);
  painter.drawText(inside.adjusted(0, words.height(), 0, 0), Qt::AlignCenter | Qt::TextWordWrap, remedy);
}

/// The region of a lesion that is not known well enough to be drawn itself: dashed, and never filled.
void draw_region(QPainter& painter, const Layout& layout, Label lesion, const QPolygonF& region) {
  if (region.isEmpty()) return;
  const double width = std::max(1.5, layout.text / 7.0);
  draw_dashes(
      painter, region, true,
      {.colour = colour_of(lesion), .below = QColor(0, 0, 0, 170), .width = width, .is_whole_below = true});
}

/// Whose region it is, and how far it reaches, beside it where no other words stand.
void name_region(QPainter& painter, const Layout& layout, Taken& taken, const LesionVerdict& verdict,
                 const QPolygonF& region) {
  const QRectF around = region.boundingRect();
  if (region.isEmpty() || !QRectF(QPointF(0, 0), QSizeF(layout.size)).intersects(around)) return;
  const QString text = Overlay::lesion(verdict.lesion) + QStringLiteral("  ") + Overlay::reach(verdict.reach);
  const QFont font = layout.font(true, 0.9);
  const QFontMetrics metrics(font);
  const QRectF box =
      taken.beside(around, QSizeF(metrics.horizontalAdvance(text) + layout.margin, metrics.height()));
  draw_plate(painter, box);
  painter.setFont(font);
  painter.setPen(colour_of(verdict.lesion));
  painter.drawText(box, Qt::AlignCenter, text);
}

/// Which lesions are not drawn as themselves, and why: under the status line. What holds for all is said of
/// the whole.
void draw_lesion_limits(QPainter& painter, const Layout& layout, Taken& taken,
                        const std::vector<LesionVerdict>& lesions) {
  constexpr int kMost = 3;  // more would cover the organ
  QStringList lines;
  int rest = 0;
  for (const LesionVerdict& verdict : lesions) {
    if (verdict.level == Level::valid || verdict.reason == LesionReason::with_the_whole) continue;
    if (lines.size() < kMost)
      lines << Overlay::limit(verdict);
    else
      ++rest;
  }
  if (lines.isEmpty()) return;
  if (rest > 0) lines << Overlay::more(rest);
  const QFont font = layout.font();
  const QFontMetrics metrics(font);
  const int top = 2 * layout.margin + QFontMetrics(layout.font()).height();
  const QRect room(0, 0, layout.size.width() * 3 / 5, layout.size.height());
  const QString text = lines.join(QLatin1Char('\n'));
  const QRect words = metrics.boundingRect(room, Qt::AlignLeft | Qt::TextWordWrap, text);
  const QRectF box = taken.below(
      QRectF(layout.margin, top, words.width() + layout.margin, words.height() + layout.margin / 2.0));
  draw_plate(painter, box);
  painter.setFont(font);
  painter.setPen(kAmber);
  painter.drawText(box.adjusted(layout.margin / 2.0, layout.margin / 4.0, 0, 0),
                   Qt::AlignLeft | Qt::TextWordWrap, text);
}

/// Level, frame, age, rate: what a person looks at first.
void draw_status(QPainter& painter, const Layout& layout, Taken& taken, const OverlayFrame& overlay,
                 const OverlayStatus& status) {
  const bool is_proposed = overlay.validity == Validity::proposed;
  QStringList words{is_proposed     ? Overlay::proposed()
                    : status.stands ? Overlay::not_live()
                                    : Overlay::level(overlay.level()),
                    Overlay::frame(overlay.index)};
  if (status.age_seconds > 0.0) words << Overlay::age(status.age_seconds);
  if (status.frames_per_second > 0.0) words << Overlay::rate(status.frames_per_second);
  if (overlay.level() != Level::withdrawn && !is_proposed) words << Overlay::residual(overlay.residual);
  draw_text(painter, layout, taken, words.join(QStringLiteral("  ·  ")), layout.font(status.stands),
            status.stands ? kAmber : kWords, Qt::AlignLeft | Qt::AlignTop);
}

void draw_doubts(QPainter& painter, const Layout& layout, Taken& taken, const OverlayFrame& overlay,
                 const OverlayStatus& status) {
  QStringList doubts;
  if (overlay.doubtful) doubts << Overlay::doubtful();
  if (status.model_unchecked) doubts << Overlay::unchecked();
  if (status.landmarks_open)
    doubts << Overlay::landmarks_open();
  else if (status.landmarks_from_statistics)
    doubts << Overlay::landmarks_from_statistics();
  if (!doubts.isEmpty())
    draw_text(painter, layout, taken, doubts.join(QStringLiteral("  ·  ")), layout.font(true), kAmber,
              Qt::AlignRight | Qt::AlignTop);
}

}  // namespace

void annotate(Canvas& picture, const OverlayFrame& overlay, const Annotations& annotations,
              const OverlayStyle& style, const OverlayStatus& status) {
  QImage image(picture.bytes->data(), picture.width, picture.height,
               static_cast<qsizetype>(picture.width) * 3, QImage::Format_BGR888);
  const Layout layout(image.size());
  Taken taken(layout);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  const bool drawn = overlay.level() != Level::withdrawn;
  if (drawn && style.anterior_margin)
    for (const auto& piece : annotations.margin) draw_margin(painter, layout, piece);
  if (drawn)
    for (std::size_t i = 0; i < annotations.regions.size(); ++i)
      draw_region(painter, layout, annotations.lesions[i].lesion, annotations.regions[i]);
  if (drawn && annotations.card)
    draw_card_marks(painter, layout, *annotations.card, annotations.camera, style.ruler);
  // Words in the order of their weight: who comes later gives way.
  if (style.status) draw_status(painter, layout, taken, overlay, status);
  if (drawn) draw_doubts(painter, layout, taken, overlay, status);
  if (overlay.level() != Level::valid) draw_limit(painter, layout, taken, overlay.validity, status.refused);
  if (drawn) {
    if (style.legend) draw_legend(painter, layout, taken, annotations.structures);
    draw_lesion_limits(painter, layout, taken, annotations.lesions);
    if (style.status && style.look == Look::contours && style.legend)
      draw_text(painter, layout, taken, Overlay::contours(), layout.font(), kWords,
                Qt::AlignHCenter | Qt::AlignBottom);
  }
  if (style.status)
    draw_text(painter, layout, taken, Overlay::research(), layout.font(false, 0.8), QColor(190, 197, 202),
              Qt::AlignRight | Qt::AlignBottom);
  if (drawn) {
    if (annotations.card) draw_card(painter, layout, taken, *annotations.card);
    for (std::size_t i = 0; i < annotations.regions.size(); ++i)
      name_region(painter, layout, taken, annotations.lesions[i], annotations.regions[i]);
  }
}

std::string validity_text(Validity validity) { return Overlay::reason(validity).toStdString(); }
std::string remedy_text(Validity validity) { return Overlay::remedy(validity).toStdString(); }
std::string lesion_reason_text(LesionReason reason) { return Overlay::reason(reason).toStdString(); }

}  // namespace glisson::scene
