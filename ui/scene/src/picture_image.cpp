// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/scene/picture_image.h"

#include <algorithm>

namespace glisson::scene {

QImage view_as_image(const Picture& picture) {
  if (picture.empty()) return {};
  using Bytes = std::shared_ptr<const std::vector<std::uint8_t>>;
  auto keeper = std::make_unique<Bytes>(picture.bytes);
  const QImage::Format format = picture.channels == 1 ? QImage::Format_Grayscale8 : QImage::Format_BGR888;
  return {picture.bytes->data(),
          picture.width,
          picture.height,
          static_cast<qsizetype>(picture.width) * picture.channels,
          format,
          [](void* bytes) { delete static_cast<Bytes*>(bytes); },
          keeper.release()};
}

QImage copy_to_image(const Picture& picture) {
  return view_as_image(picture).convertToFormat(QImage::Format_RGB32);
}

Picture to_picture(const QImage& image) {
  const QImage bgr = image.convertToFormat(QImage::Format_BGR888);
  const auto row_bytes = static_cast<std::size_t>(3 * bgr.width());
  auto bytes =
      std::make_shared<std::vector<std::uint8_t>>(row_bytes * static_cast<std::size_t>(bgr.height()));
  for (int row = 0; row < bgr.height(); ++row)  // QImage pads its rows
    std::copy_n(bgr.constScanLine(row), row_bytes,
                bytes->begin() + static_cast<std::ptrdiff_t>(row_bytes) * row);
  return {bgr.width(), bgr.height(), 3, bytes};
}

}  // namespace glisson::scene
