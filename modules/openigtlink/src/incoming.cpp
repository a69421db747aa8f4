// SPDX-License-Identifier: GPL-3.0-or-later
#include "incoming.h"

#include <igtl_header.h>
#include <igtl_image.h>
#include <igtl_transform.h>
#include <igtl_util.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "glisson/core/units.h"

namespace glisson::openigtlink {
namespace {

/// More than the pictures of any camera: 8K in three colours.
constexpr std::uint64_t kMostBytes = 100'000'000;
constexpr int kLeastSide = 16, kMostSide = 16384;  // pixels

/// Of a field that may fill its place without an end.
std::string text_in(const char* field, std::size_t size) { return {field, strnlen(field, size)}; }

bool is_printable(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](char letter) { return letter >= ' ' && letter <= '~'; });
}

std::uint32_t big_endian(std::string_view bytes) {
  std::uint32_t value = 0;
  for (const char byte : bytes) value = value << 8 | static_cast<unsigned char>(byte);
  return value;
}

/// The content of a body that begins with an extended header and ends with other data (protocol 3).
std::optional<std::string_view> inner(std::string_view body) {
  constexpr std::size_t kLeast = 12;
  if (body.size() < kLeast) return {};
  const std::size_t before = big_endian(body.substr(0, 2)), index = big_endian(body.substr(2, 2)),
                    data = big_endian(body.substr(4, 4));
  if (before < kLeast || before + index + data > body.size()) return {};
  return body.substr(before, body.size() - before - index - data);
}

bool is_picture(const igtl_image_header& header) {
  const auto fits = [](int side) { return side >= kLeastSide && side <= kMostSide; };
  const bool is_whole =
      std::equal(std::begin(header.size), std::end(header.size), std::begin(header.subvol_size)) &&
      std::all_of(std::begin(header.subvol_offset), std::end(header.subvol_offset),
                  [](int offset) { return offset == 0; });
  return header.version == IGTL_IMAGE_HEADER_VERSION && is_whole && header.size[2] == 1 &&
         fits(header.size[0]) && fits(header.size[1]) && header.scalar_type == IGTL_IMAGE_STYPE_TYPE_UINT8 &&
         (header.num_components == 1 || header.num_components == 3);
}

}  // namespace

std::optional<Head> read_head(std::string_view bytes) {
  if (bytes.size() < kHeadSize) return {};
  igtl_header raw;
  static_assert(sizeof raw == kHeadSize);
  std::memcpy(&raw, bytes.data(), kHeadSize);
  igtl_header_convert_byte_order(&raw);
  Head head;
  head.version = raw.version;
  head.type = text_in(raw.name, IGTL_HEADER_TYPE_SIZE);
  head.device = text_in(raw.device_name, IGTL_HEADER_NAME_SIZE);
  const std::uint64_t stamp = raw.timestamp;
  head.seconds = static_cast<double>(stamp >> 32) + static_cast<double>(stamp & 0xffffffffU) / 4294967296.0;
  head.size = raw.body_size;
  head.crc = raw.crc;
  const bool is_one = head.version >= 1 && head.version <= 3 && !head.type.empty() &&
                      is_printable(head.type) && is_printable(head.device) && head.size <= kMostBytes;
  return is_one ? std::optional(head) : std::nullopt;
}

std::optional<std::string_view> content_of(const Head& head, std::string_view body) {
  // The library does not change what it sums up.
  auto* bytes = reinterpret_cast<unsigned char*>(const_cast<char*>(body.data()));
  if (body.size() != head.size || crc64(bytes, body.size(), 0) != head.crc) return {};
  return head.version == 1 ? std::optional(body) : inner(body);
}

std::optional<Picture> picture_in(std::string_view content) {
  igtl_image_header header;
  static_assert(sizeof header == IGTL_IMAGE_HEADER_SIZE);
  if (content.size() < sizeof header) return {};
  std::memcpy(&header, content.data(), sizeof header);
  igtl_image_convert_byte_order(&header);
  if (!is_picture(header)) return {};
  const std::string_view pixels = content.substr(sizeof header);
  const int width = header.size[0], height = header.size[1], channels = header.num_components;
  if (pixels.size() !=
      static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * static_cast<std::size_t>(channels))
    return {};
  auto bytes = std::make_shared<std::vector<std::uint8_t>>(pixels.begin(), pixels.end());
  if (channels == 3)  // red comes first there, blue here
    for (std::size_t i = 0; i + 2 < bytes->size(); i += 3) std::swap((*bytes)[i], (*bytes)[i + 2]);
  return Picture{width, height, channels, std::move(bytes)};
}

std::optional<Rigid<CameraFrame, ToolFrame>> pose_in(std::string_view content) {
  constexpr double kFarthest = 10.0;  // metres
  constexpr double kTurned = 1e-2;    // of single precision and rounded texts on the way
  igtl_float32 values[12];
  if (content.size() != sizeof values) return {};
  std::memcpy(values, content.data(), sizeof values);
  igtl_transform_convert_byte_order(values);
  Rigid<CameraFrame, ToolFrame> pose;
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row)
      pose.rotation(row, column) = static_cast<double>(values[3 * column + row]);
  for (int row = 0; row < 3; ++row)
    pose.translation[row] = metres_per(LengthUnit::millimetre) * static_cast<double>(values[9 + row]);
  if (!pose.rotation.allFinite() || !pose.translation.allFinite()) return {};
  const double turned = (pose.rotation * pose.rotation.transpose() - Eigen::Matrix3d::Identity()).norm();
  if (turned > kTurned || pose.rotation.determinant() < 0.0 || pose.translation.norm() > kFarthest) return {};
  return pose;
}

bool Messages::feed(std::string_view bytes) {
  while (!bytes.empty()) {
    if (!head_) {
      const std::string_view part = bytes.substr(0, kHeadSize - head_bytes_.size());
      head_bytes_ += part;
      bytes.remove_prefix(part.size());
      if (head_bytes_.size() < kHeadSize) return true;
      head_ = read_head(head_bytes_);
      head_bytes_.clear();
      if (!head_) return false;
      is_wanted_ = wants_(*head_);
      left_ = head_->size;
      body_.clear();
    }
    // Grows by what comes, not by what was announced.
    const std::string_view part =
        bytes.substr(0, static_cast<std::size_t>(std::min<std::uint64_t>(left_, bytes.size())));
    if (is_wanted_) body_ += part;
    left_ -= part.size();
    bytes.remove_prefix(part.size());
    if (left_ == 0) end_message();
  }
  return true;
}

void Messages::end_message() {
  if (is_wanted_) {
    if (const auto content = content_of(*head_, body_))
      take_(*head_, *content);
    else
      ++damaged_;
  }
  head_.reset();
}

}  // namespace glisson::openigtlink
