// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sitting.h"

namespace glisson::stopwatch {

/// How the labels of the command line differ from the window's.
struct Comparison {
  std::vector<long> voxels_apart;  ///< after the segmentation, and after each correction
  long saved_apart = 0;            ///< of the case that the window has saved
  double seconds = 0.0;            ///< that the command line took, import and saving included
};

/// Does with `glisson import` and `glisson segment` what was done in the window, from the same folder and the
/// same seeds. @param folder to work in, exists. @throws std::runtime_error when a command fails.
Comparison do_the_same(const std::filesystem::path& ct, const Sitting& sitting,
                       const std::filesystem::path& folder);

}  // namespace glisson::stopwatch
