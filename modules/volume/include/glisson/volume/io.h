// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "glisson/core/run_context.h"
#include "glisson/volume/image.h"
#include "glisson/volume/label_volume.h"

namespace glisson {

/// Reads a volume: a folder of DICOM slices, its DICOMDIR, a .zip or .tar.gz of one (unpacked here), NIfTI,
/// NRRD, MetaImage, VTI.
/// The result is right for every axis flip and permutation: grid.direction carries it.
/// @param series which of several series below a DICOM folder (or in an archive): its UID, or its number.
///   Empty: the only one.
/// @throws FileError missing or unreadable; InputError empty folder (or one without a file), several series
///   and none chosen (the sentence lists them), missing slice, gantry tilt, unit-less geometry, not a scalar
///   volume. Parsers that can abort run in a child process.
Cancellable<Image> read_image(const std::filesystem::path& path, const RunContext& context,
                              const std::string& series = {});

/// "ct", "mr", "other".
const char* modality_code(Modality modality);
/// The modality of such a code; empty: none has it.
std::optional<Modality> modality_named(std::string_view code);

/// What a label file says of one of its labels (from .seg.nrrd; elsewhere only the code is known).
struct LabelInfo {
  Label code = 0;
  std::string name;         ///< may be empty
  std::string terminology;  ///< Slicer's Segmentation_TerminologyEntry, kept as it is; may be empty
  std::array<double, 3> colour = {0.5, 0.5, 0.5};
  /// How far the work on it has come, as Slicer's tag says it: "notstarted", "inprogress", "completed",
  /// "flagged"; may be empty.
  std::string status = {};
};
/// Labels as a file holds them. There may be infos of labels without voxels, and voxels without an info.
struct LabelFile {
  LabelVolume voxels;
  std::vector<LabelInfo> infos;
};
/// Reads labels: .seg.nrrd (also with several layers), NRRD, NIfTI, MetaImage, VTI. @throws as read_image,
/// and InputError an archive: which of its files are the labels is for a person to say.
Cancellable<LabelFile> read_labels(const std::filesystem::path& path, const RunContext& context);
/// The same, to its end.
LabelFile read_labels(const std::filesystem::path& path);

/// Writes Hounsfield units as int16, compressed; the format by extension (.nrrd, .nii.gz, .mha). Atomic, read
/// back.
void write_image(const std::filesystem::path& path, const Image& image);
/// Writes labels by extension: .seg.nrrd as Slicer reads it (names, colours, terminology), else plain.
/// Atomic.
void write_labels(const std::filesystem::path& path, const LabelVolume& labels,
                  const std::vector<LabelInfo>& infos);

/// @throws InputError naming `name` when two volumes that belong together differ in size or place.
void require_same_grid(const VolumeGrid& a, const VolumeGrid& b, const std::string& name);

}  // namespace glisson
