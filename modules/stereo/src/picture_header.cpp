// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture_header.h"

#include <cstdint>

namespace glisson::stereo {
namespace {

using namespace std::string_view_literals;

/// A whole number at a place; 0 beyond the end.
std::uint32_t number(std::string_view bytes, std::size_t at, std::size_t size, bool big) {
  if (at > bytes.size() || size > bytes.size() - at) return 0;
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < size; ++i)
    value = value << 8 | static_cast<unsigned char>(bytes[big ? at + i : at + size - 1 - i]);
  return value;
}

PictureHeader png(std::string_view bytes) {
  if (bytes.size() < 16 || bytes.substr(12, 4) != "IHDR") return {};
  return {"PNG", number(bytes, 16, 4, true), number(bytes, 20, 4, true)};
}

/// Segment after segment up to the first that tells a size.
PictureHeader jpeg(std::string_view bytes) {
  for (std::size_t at = 2; at + 9 < bytes.size();) {
    if (bytes[at] != '\xFF') return {};
    const auto kind = static_cast<unsigned char>(bytes[at + 1]);
    if (kind == 0xFF) {  // padding
      ++at;
      continue;
    }
    const bool frame = kind >= 0xC0 && kind <= 0xCF && kind != 0xC4 && kind != 0xC8 && kind != 0xCC;
    if (frame) return {"JPEG", number(bytes, at + 7, 2, true), number(bytes, at + 5, 2, true)};
    const std::uint32_t length = number(bytes, at + 2, 2, true);
    if (kind == 0xD9 || kind == 0xDA || length < 2) return {};
    at += 2 + length;
  }
  return {};
}

PictureHeader bmp(std::string_view bytes) {
  const std::uint32_t header = number(bytes, 14, 4, false);
  if (header == 12) return {"BMP", number(bytes, 18, 2, false), number(bytes, 20, 2, false)};
  const auto height = static_cast<std::int32_t>(number(bytes, 22, 4, false));  // negative: from the top
  return {"BMP", number(bytes, 18, 4, false), height < 0 ? -static_cast<long>(height) : height};
}

PictureHeader tiff(std::string_view bytes) {
  const bool big = bytes[0] == 'M';
  const std::size_t list = number(bytes, 4, 4, big);
  PictureHeader header{"TIFF", 0, 0};
  const std::uint32_t entries = number(bytes, list, 2, big);
  for (std::uint32_t n = 0; n < entries && n < 4096; ++n) {
    const std::size_t at = list + 2 + 12UL * n;
    const std::uint32_t tag = number(bytes, at, 2, big), type = number(bytes, at + 2, 2, big);
    const long value = number(bytes, at + 8, type == 3 ? 2 : 4, big);
    if (tag == 256) header.width = value;
    if (tag == 257) header.height = value;
  }
  return header;
}

}  // namespace

std::optional<PictureHeader> picture_header(std::string_view bytes) {
  PictureHeader header;
  if (bytes.starts_with("\x89PNG\r\n\x1A\n"sv))
    header = png(bytes);
  else if (bytes.starts_with("\xFF\xD8\xFF"sv))
    header = jpeg(bytes);
  else if (bytes.starts_with("BM"sv))
    header = bmp(bytes);
  else if (bytes.starts_with("II*\0"sv) || bytes.starts_with("MM\0*"sv))
    header = tiff(bytes);
  if (header.width < 1 || header.height < 1) return std::nullopt;
  return header;
}

}  // namespace glisson::stereo
