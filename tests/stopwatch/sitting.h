// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "glisson/patient/label_map.h"
#include "glisson/segmentation/segment.h"
#include "hand.h"

namespace glisson::stopwatch {

/// What somebody does at the window who has a CT's folder and wants an approved segmentation.
struct SittingOptions {
  std::filesystem::path ct;            ///< a folder of DICOM slices
  std::filesystem::path truth, codes;  ///< an expert's labels of that CT; empty: nobody knows
  std::filesystem::path out;           ///< exists; photographs, seeds and the case are put here
  std::uint64_t seed = 1001;           ///< of the clicks
  bool lesions = false;                ///< a click on each
  bool proposes = false;               ///< *Propose the liver* instead of clicks
  int corrections = 3;                 ///< at most
};

/// What came of it.
struct Sitting {
  Ledger ledger;
  std::vector<segmentation::Seeds> seeds;  ///< as they were segmented from; then after each correction
  std::vector<LabelVolume> labels;         ///< that came of each of them
  std::vector<double> dice;                ///< of the liver with all that lies in it; empty: no truth
  double placed_off_mm = 0.0;              ///< the farthest that a click lies from where it was meant
  std::filesystem::path saved;             ///< the case
};

/// Opens, clicks, segments, looks, corrects, looks again, approves each label, saves. Where the eye is
/// concerned (what is liver, what is wrong) it goes by the truth, as insilico::LaypersonOptions has it;
/// without one the proposal is taken as it comes. @throws std::runtime_error where a person could not go on.
Sitting sit(const SittingOptions& options, ui::MainWindow& window);

}  // namespace glisson::stopwatch
