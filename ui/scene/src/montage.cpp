// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/scene/montage.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "glisson/core/error.h"
#include "glisson/ui/scene/picture_image.h"
#include "overlay_layout.h"

namespace glisson::scene {

Picture montage(const std::vector<NamedPicture>& pictures, int columns, double scale) {
  constexpr int kGap = 4;  // pixels
  require(!pictures.empty() && columns > 0 && scale > 0.0 && scale <= 1.0,
          "a montage has pictures, columns and a scale up to 1");
  const Picture& first = pictures.front().picture;
  for (const NamedPicture& one : pictures)
    require(one.picture.width == first.width && one.picture.height == first.height && !one.picture.empty(),
            "the pictures of a montage have one size");
  const QSize size(static_cast<int>(std::lround(scale * first.width)),
                   static_cast<int>(std::lround(scale * first.height)));
  const int count = static_cast<int>(pictures.size());
  const int across = std::min(columns, count), down = (count + columns - 1) / columns;
  QImage sheet(across * (size.width() + kGap) - kGap, down * (size.height() + kGap) - kGap,
               QImage::Format_RGB32);
  sheet.fill(Qt::black);
  QPainter painter(&sheet);
  const Layout layout(size);
  for (int i = 0; i < count; ++i) {
    const NamedPicture& one = pictures[static_cast<std::size_t>(i)];
    const QPoint corner(i % columns * (size.width() + kGap), i / columns * (size.height() + kGap));
    painter.drawImage(corner, screen_image(one.picture, size));
    const QFont font = layout.font(true, 1.4);
    const QString name = QString::fromStdString(one.name);
    const QRect words = QFontMetrics(font).boundingRect(name);
    QRect plate(0, 0, words.width() + 4 * layout.margin, words.height() + layout.margin);
    plate.moveCenter({corner.x() + size.width() / 2, 0});
    plate.moveTop(corner.y() + 5 * layout.margin);
    draw_plate(painter, plate);
    painter.setFont(font);
    painter.setPen(kWords);
    painter.drawText(plate, Qt::AlignCenter, name);
  }
  painter.end();
  return to_picture(sheet);
}

}  // namespace glisson::scene
