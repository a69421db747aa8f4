// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "glisson/core/run_context.h"
#include "glisson/network/label_sheet.h"
#include "glisson/patient/label_map.h"
#include "glisson/volume/image.h"

namespace glisson::network {

/// What is not left to the network.
struct LabelOptions {
  /// Labels that neither lose nor gain a voxel.
  std::vector<Label> locked;
};
/// A CT's labels by a network.
struct NetworkLabels {
  LabelMap labels;                 ///< on the image's grid
  long tiles = 0;                  ///< that the network was run on
  std::vector<std::string> notes;  ///< codes with values: "network.small_lesions 3"
};

/// Labels a CT by a person's own segmentation network (ONNX): in overlapping tiles, slices or blocks, whose
/// scores are blended; slices keep to the axes that the sheet names.
/// @param kept labels on the image's grid; of these all that the network does not know stay, voxel by voxel.
/// @throws FileError, InputError naming file, field and remedy: not a CT, another grid, a network that cannot
///   be run or whose input or output does not fit the sheet.
Cancellable<NetworkLabels> label_by_network(const Image& image, const std::filesystem::path& network,
                                            const LabelSheet& sheet, const LabelOptions& options,
                                            const RunContext& context, const LabelMap* kept = nullptr);

}  // namespace glisson::network
