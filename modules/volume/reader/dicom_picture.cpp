// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "dicom_objects.h"
#include "dicom_pixels.h"

namespace glisson::reader {
namespace {

/// At most 128 pixels a side, each the mean of those that it stands for. A CT in a window for soft tissue,
/// others from their second to their last but second percent.
SeriesPicture reduced(const std::vector<float>& values, const DicomSeries& series) {
  constexpr int kSide = 128;
  constexpr int kManyValues = 256;
  constexpr float kLow = -160.0F, kHigh = 240.0F;  // HU
  const int width = series.pixels.x(), height = series.pixels.y();
  SeriesPicture picture;
  std::vector<float> sorted = values;
  std::ranges::sort(sorted);
  for (std::size_t n = 0; n < sorted.size() && picture.values < kManyValues; ++n)
    if (n == 0 || sorted[n] != sorted[n - 1]) ++picture.values;
  const bool hounsfield = series.modality == "CT" && picture.values > 2;
  const std::size_t rim = sorted.size() / 50;
  const float low = hounsfield ? kLow : sorted[picture.values > 2 ? rim : 0];
  const float high = hounsfield ? kHigh : sorted[sorted.size() - 1 - (picture.values > 2 ? rim : 0)];
  const int step = (std::max(width, height) + kSide - 1) / kSide;
  picture.width = (width + step - 1) / step;
  picture.height = (height + step - 1) / step;
  if (series.pixel_mm.minCoeff() > 0.0)
    picture.pixel_aspect = std::clamp(series.pixel_mm.y() / series.pixel_mm.x(), 0.1, 10.0);
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      double sum = 0.0;
      int count = 0;
      for (int j = y * step; j < std::min(height, (y + 1) * step); ++j)
        for (int i = x * step; i < std::min(width, (x + 1) * step); ++i, ++count)
          sum += static_cast<double>(values[static_cast<std::size_t>(i) +
                                            static_cast<std::size_t>(width) * static_cast<std::size_t>(j)]);
      const double share =
          high > low ? (sum / count - static_cast<double>(low)) / static_cast<double>(high - low) : 0.0;
      picture.grey.push_back(static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(share, 0.0, 1.0))));
    }
  return picture;
}

}  // namespace

SeriesPicture dicom_picture(const Request& request) {
  gdcm::Reader header;
  header.SetFileName(request.path.c_str());
  if (!header.CanRead() || !header.ReadUpToTag(gdcm::Tag(0x0028, 0x0100)))
    refuse(request, request.path.filename().string(), "is a DICOM file that cannot be read",
           "Export the series again");
  const gdcm::DataSet& data = header.GetFile().GetDataSet();
  const DicomSeries series = described(request.path, data).series;
  if (series.pixels.minCoeff() < 1 || series.pixels.maxCoeff() > kMostPixels || series.frames > 1)
    refuse(request, request.path.filename().string(), "holds no slice", "Choose another series");
  raise_limits(total_bytes({request.path}), static_cast<double>(series.pixels.x()) * series.pixels.y());
  std::vector<float> values;
  append_slice(request, request.path, series.pixels, values);
  SeriesPicture picture = reduced(values, series);
  if (text_of(data, {0x0028, 0x0004}) == "MONOCHROME1" && series.modality != "CT")
    for (std::uint8_t& grey : picture.grey) grey = static_cast<std::uint8_t>(255 - grey);
  return picture;
}

}  // namespace glisson::reader
