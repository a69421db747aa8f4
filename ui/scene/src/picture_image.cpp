// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/scene/picture_image.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "canvas.h"

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

QImage screen_image(const Picture& picture, const QSize& size) {
  if (picture.empty() || size.isEmpty()) return {};
  const cv::Mat source(picture.height, picture.width, picture.channels == 1 ? CV_8UC1 : CV_8UC3,
                       const_cast<std::uint8_t*>(picture.bytes->data()));
  cv::Mat scaled = source;
  const cv::Size wanted(size.width(), size.height());
  // Beyond half of the size two neighbours do not tell what lies between. Means of four are soon made, those
  // of any other size take five times as long.
  while (2 * wanted.width <= scaled.cols && 2 * wanted.height <= scaled.rows) {
    cv::Mat half;
    cv::resize(scaled, half, scaled.size() / 2, 0.0, 0.0, cv::INTER_AREA);
    scaled = half;
  }
  if (wanted != scaled.size()) cv::resize(cv::Mat(scaled), scaled, wanted, 0.0, 0.0, cv::INTER_LINEAR);
  QImage image(size, QImage::Format_RGB32);
  cv::Mat target(wanted, CV_8UC4, image.bits(), static_cast<std::size_t>(image.bytesPerLine()));
  cv::cvtColor(scaled, target, picture.channels == 1 ? cv::COLOR_GRAY2BGRA : cv::COLOR_BGR2BGRA);
  return image;
}

Canvas canvas_of(const Picture& picture) {
  const Picture colour = picture.channels == 3 ? picture : to_picture(view_as_image(picture));
  return {picture.width, picture.height, std::make_shared<std::vector<std::uint8_t>>(*colour.bytes)};
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
