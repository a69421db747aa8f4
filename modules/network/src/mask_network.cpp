// SPDX-License-Identifier: GPL-3.0-or-later
#include "mask_network.h"

#include <array>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "glisson/core/error.h"
#include "sheet.h"

namespace glisson::network {
namespace {

/// The picture in the network's size, colour by colour, from 0 to 1 or by mean and deviation.
Tensor input_of(const Picture& picture, const MaskSheet& sheet, int rows, int columns) {
  const cv::Mat whole(picture.height, picture.width, picture.channels == 1 ? CV_8UC1 : CV_8UC3,
                      const_cast<std::uint8_t*>(picture.bytes->data()));
  cv::Mat small;
  cv::resize(whole, small, cv::Size(columns, rows), 0, 0, cv::INTER_AREA);
  const bool wants_grey = sheet.colours == MaskSheet::Colours::grey;
  if (wants_grey && small.channels() == 3) cv::cvtColor(small, small, cv::COLOR_BGR2GRAY);
  if (!wants_grey && small.channels() == 1) cv::cvtColor(small, small, cv::COLOR_GRAY2BGR);
  const int colours = sheet.colour_count();
  Tensor input{{1, colours, rows, columns}, {}};
  input.values.resize(value_count(input.shape));
  float* value = input.values.data();
  for (int colour = 0; colour < colours; ++colour) {
    const int from = sheet.colours == MaskSheet::Colours::rgb ? 2 - colour : colour;
    const auto n = static_cast<std::size_t>(colour);
    const double zero = sheet.mean.empty() ? 0.0 : sheet.mean[n], one = sheet.sd.empty() ? 1.0 : sheet.sd[n];
    std::array<float, 256> of{};
    for (std::size_t level = 0; level < of.size(); ++level)
      of[level] = static_cast<float>((static_cast<double>(level) / 255.0 - zero) / one);
    for (int y = 0; y < rows; ++y) {
      const std::uint8_t* row = small.ptr<std::uint8_t>(y) + from;
      for (int x = 0; x < columns; ++x) *value++ = of[row[x * colours]];
    }
  }
  return input;
}

}  // namespace

MaskNetwork::MaskNetwork(std::unique_ptr<NetworkRunner> runner, MaskSheet sheet, int rows, int columns)
    : runner_(std::move(runner)), sheet_(std::move(sheet)), rows_(rows), columns_(columns) {}

std::unique_ptr<MaskNetwork> MaskNetwork::open(const std::filesystem::path& path, const RunContext& context,
                                               int threads) {
  MaskSheet sheet = read_mask_sheet(path);
  auto runner = NetworkRunner::open(path, context, threads);
  if (!runner) return nullptr;
  const std::vector<int>& shape = runner->input_shape();
  const auto fits = [](int side, int wanted) { return side < 0 || side == wanted; };
  const bool is_picture = shape.empty() || (shape.size() == 4 && fits(shape[0], 1));
  if (!is_picture || (shape.size() == 4 && !fits(shape[1], sheet.colour_count())))
    throw InputError(
        path.string(), "input",
        "is " + shape_text(shape) + ", not 1 x " + std::to_string(sheet.colour_count()) + " x rows x columns",
        "Export a network of one picture, and say its colours (\"colours\")");
  std::vector<int> size = sheet.size;
  const bool says_size = shape.size() == 4 && shape[2] > 0 && shape[3] > 0;
  if (size.empty() && says_size) size = {shape[2], shape[3]};
  if (size.empty())
    throw InputError(sheet_of(path).string(), "size",
                     "is missing where the network leaves its input's size open", "Write [rows, columns]");
  if (shape.size() == 4 && !(fits(shape[2], size[0]) && fits(shape[3], size[1])))
    throw InputError(
        sheet_of(path).string(), "size",
        "is " + shape_text(size) + " where the network's input is " + shape_text({shape[2], shape[3]}),
        "Write the size of the network's input");
  return std::unique_ptr<MaskNetwork>(new MaskNetwork(std::move(runner), std::move(sheet), size[0], size[1]));
}

Cancellable<Picture> MaskNetwork::not_liver(const Picture& picture, const RunContext& context) {
  require(!picture.empty(), "a mask is of a picture");
  const int channels = static_cast<int>(sheet_.channels.size());
  const auto scores =
      runner_->run(input_of(picture, sheet_, rows_, columns_), {1, channels, rows_, columns_}, context);
  if (!scores) return std::nullopt;
  cv::Mat small(rows_, columns_, CV_8UC1), whole;
  const std::size_t stride = small.total();
  for (std::size_t n = 0; n < stride; ++n)
    small.data[n] = sheet_.is_not_liver(scores->values.data() + n, stride) ? 255 : 0;
  cv::resize(small, whole, cv::Size(picture.width, picture.height), 0, 0, cv::INTER_NEAREST);
  return Picture{picture.width, picture.height, 1,
                 std::make_shared<std::vector<std::uint8_t>>(whole.datastart, whole.dataend)};
}

}  // namespace glisson::network
