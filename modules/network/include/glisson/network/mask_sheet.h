// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace glisson::network {

/// What a mask network wants of a laparoscope's picture and which of its channels may be liver: MODEL.json
/// beside MODEL.onnx. The picture is brought to the network's size, as a whole.
struct MaskSheet {
  enum class Colours { rgb, bgr, grey };
  /// "colours": the order of the input's channels; "grey": one.
  Colours colours = Colours::rgb;
  /// "mean", "sd", both or neither: (x - mean) / sd of each colour, x from 0 to 1.
  std::vector<double> mean, sd;
  /// "size": rows and columns of the input. Empty: as the network's file says it.
  std::vector<int> size;
  /// "channels": a name for each output channel.
  std::vector<std::string> channels;
  /// "liver": those of them that may be liver; all others are not. One entry a channel.
  std::vector<char> is_liver;
  /// "threshold": a pixel is not liver if a channel of something else scores above it, or if no liver channel
  /// does (where there is any). Empty: the channel with the highest score decides.
  std::optional<double> threshold;
  /// "oldest_seconds": a mask of a picture that is older is not used.
  double oldest_seconds = 0.5;

  int colour_count() const { return colours == Colours::grey ? 1 : 3; }
  /// Whether scores, one a channel, `stride` apart, say that a pixel is not liver.
  bool is_not_liver(const float* scores, std::size_t stride) const;
};

/// Reads the sheet of a mask network. @throws FileError, InputError naming file, field and remedy.
MaskSheet read_mask_sheet(const std::filesystem::path& network);

}  // namespace glisson::network
