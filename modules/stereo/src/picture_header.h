// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

namespace glisson::stereo {

/// What a picture's file says of itself before it is decoded.
struct PictureHeader {
  const char* format = "";
  long width = 0, height = 0;
};

/// Reads the header of a PNG, JPEG, BMP or TIFF, strictly. Empty: it is none of them, or its header is
/// damaged. Other formats are not for the decoder: each is a parser more that foreign bytes would reach.
std::optional<PictureHeader> picture_header(std::string_view bytes);

}  // namespace glisson::stereo
