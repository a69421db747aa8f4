// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "glisson/patient/picture.h"

namespace glisson::stereo {

/// Reads pictures that belong together (a folder's, a case's) through one process of its own, which decodes
/// them and can do nothing else. What breaks that process costs the picture a sentence; another is started
/// for the next one. A picture that takes the process over could falsify those that come after it through
/// the same reader, no others.
class PictureReader {
 public:
  PictureReader();
  ~PictureReader();
  /// PNG, JPEG, BMP or TIFF, up to 64 million pixels; 8 bits, as the sensor saw it (no rotation by a tag).
  /// @throws FileError, InputError naming the file.
  Picture read(const std::filesystem::path& path);
  /// The same of a file's bytes. @param name what errors call them.
  Picture decode(const std::string& content, const std::string& name);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// What the program that reads pictures could do although it must not, as reader_escapes() of volumes.
/// @throws FileError the program is missing.
std::vector<std::string> picture_reader_escapes();

}  // namespace glisson::stereo
