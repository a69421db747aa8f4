// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "glisson/patient/picture.h"

namespace glisson::stereo {

/// A picture as the bytes of a PNG file: nothing of it is lost. PictureReader::decode() gives it back.
/// @pre one channel or three, as many bytes as its size says. @throws FileError it cannot be encoded.
std::string png_of(const Picture& picture);
/// The same of a JPEG file, which loses some of it. @param quality 1 to 100.
std::string jpeg_of(const Picture& picture, int quality);

}  // namespace glisson::stereo
