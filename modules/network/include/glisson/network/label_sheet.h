// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "glisson/patient/label_map.h"

namespace glisson::network {

/// What a segmentation network wants of a CT and what its channels mean: MODEL.json beside MODEL.onnx. Lists
/// of three go slices, rows, columns, as the network's input does; lists of two go rows, columns.
struct LabelSheet {
  /// Stands for any lesion in `channels`: each piece becomes a label of its own.
  static constexpr Label kLesions = structure::kFirstLesion;

  /// "window_hu": Hounsfield units are clipped to these and mapped onto 0 to 1.
  double window_low_hu = 0.0, window_high_hu = 1.0;
  /// "mean_hu", "sd_hu", both or neither: (clipped - mean) / sd takes the place of 0 to 1.
  std::optional<double> mean_hu, sd_hu;
  /// "spacing_mm": of the voxels that the network was trained on; two numbers leave the slices as they are,
  /// none all.
  std::vector<double> spacing_mm;
  /// "axes": the direction in which slices, rows and columns run, of R or L, A or P, I or S.
  std::string axes = "SPL";
  /// "tile": the input's size; two numbers: slice by slice. Empty: as the network's file says it.
  std::vector<int> tile;
  /// "overlap": of neighbouring tiles, as a part of their side.
  double overlap = 0.5;
  /// "channels": the label of each output channel: background, lesions, or structure_name().
  std::vector<Label> channels;
  /// "threshold": what a label's score must exceed. Without it the channel with the highest score wins;
  /// needed where no channel is the background.
  std::optional<double> threshold;
  /// "least_lesion_ml": smaller pieces of a lesion are parenchyma.
  double least_lesion_ml = 0.05;

  /// Whether a label is one of the network's; with lesions any lesion is.
  bool finds(Label label) const;
};

/// Reads the sheet of a network. @throws FileError, InputError naming file, field and remedy.
LabelSheet read_label_sheet(const std::filesystem::path& network);

}  // namespace glisson::network
