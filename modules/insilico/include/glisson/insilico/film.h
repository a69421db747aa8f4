// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "glisson/core/run_context.h"
#include "glisson/insilico/theatre.h"

namespace glisson::insilico {

/// What of a theatre is filmed, and what of its truth is written beside it.
struct FilmOptions {
  int frames = 0;                      ///< how many, from the first; 0: all
  std::vector<int> picture_frames{0};  ///< also written as loss-free pictures with a depth map
  bool node_truth = true;              ///< node positions of every frame
  /// @throws InputError naming the option: more frames than the theatre has.
  void validate(const Theatre& theatre) const;
};

/// What was written; paths are inside the folder.
struct Film {
  std::filesystem::path video;        ///< side by side, mp4v in Matroska
  std::filesystem::path calibration;  ///< OpenCV YAML
  std::filesystem::path truth;  ///< folder: mesh.vtu, nodes_0000.xyz ..., targets.json, depth_0000.pfm ...
  std::vector<std::filesystem::path> left_pictures, right_pictures;
  int frames = 0;
  double visible_share = 0.0;  ///< in the first frame
  double seconds = 0.0;
};

/// Films the theatre: `stereo.mkv`, `calibration.yaml`, `left_0000.png`, `right_0000.png` and `truth/`.
/// Positions are millimetres in the left camera's frame; nodes one line each "x y z".
/// @throws FileError.
Cancellable<Film> film(const Theatre& theatre, const std::filesystem::path& folder,
                       const FilmOptions& options, const RunContext& context);

/// A depth map as a PFM file (little-endian, bottom row first, as the format wants), millimetres; 0: nothing
/// there. Atomic.
void write_depth(const std::filesystem::path& path, const std::vector<float>& depth, int width, int height);
/// @return metres, row-major from the top. @throws FileError, InputError.
std::vector<float> read_depth(const std::filesystem::path& path, int& width, int& height);

}  // namespace glisson::insilico
