// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace glisson::stereo {

/// Two picture files of one moment.
struct PicturePair {
  std::string name;  ///< what both names share, for reports
  std::filesystem::path left, right;
};
/// What was found in a folder or in two sources.
struct PicturePairs {
  std::vector<PicturePair> pairs;            ///< in the order of their names, numbers by value
  std::vector<std::filesystem::path> alone;  ///< pictures without a partner
};

/// The pairs of a folder: with subfolders "left" and "right", or with names that differ in the side only
/// ("left-798.png" and "right-798.png", "f7_L_0100.png" and "f7_R_0100.png").
/// Pictures are .png .jpg .jpeg .bmp .tif .tiff.
/// @throws FileError no such folder; InputError no pair in it.
PicturePairs picture_pairs(const std::filesystem::path& folder);

/// The pairs of two sources, each a folder or a pattern whose file name holds * or ? ("a/left-*.png").
/// Matched by name less the side; where no two names match and there are as many on either side, in order.
/// @throws FileError nothing of such a name; InputError no pair.
PicturePairs picture_pairs(const std::filesystem::path& left, const std::filesystem::path& right);

}  // namespace glisson::stereo
