// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "glisson/volume/dicom_source.h"
#include "glisson/volume/io.h"

/// @file
/// Labels as a DICOM segmentation object (PS3.3 A.51), as archives of hospitals keep them.

namespace glisson {

/// Writes a binary DICOM segmentation: a segment for each label present, with its name, colour and the codes
/// of LabelInfo::terminology (else SCT "Tissue"), frames where it has voxels, in LPS mm. It refers to study,
/// series, frame of reference and slices of `source` where these are known; the patient's name, ID and birth
/// date stay out. Atomic. @throws InputError no label, more pixels a side than DICOM counts; FileError.
void write_dicom_labels(const std::filesystem::path& path, const LabelVolume& labels,
                        const std::vector<LabelInfo>& infos, const DicomSource& source);

/// A DICOM segmentation, read; its grid is the frames', which need not be a CT's (see placed_on()).
struct DicomLabels {
  LabelFile file;
  /// Written by Glisson: the codes are those that were written. Else they are the segments' numbers.
  bool own = false;
  /// FrameOfReferenceUID: only where it is the CT's are the two placed in one another. Empty: unknown.
  std::string frame_of_reference_uid = {};
};
/// Reads one in the confined reading program. The grid reaches from the first slice with a frame to the last:
/// see placed_on(). Where segments overlap the smaller wins. @throws as read_labels.
Cancellable<DicomLabels> read_dicom_labels(const std::filesystem::path& path, const RunContext& context);

/// Whether the file bears DICOM's mark, whatever it is called.
bool has_dicom_mark(const std::filesystem::path& path);

/// The labels on `grid`, voxel by voxel, where theirs is a part of it: the same lattice to a hundredth of a
/// voxel, axes flipped or permuted as may be. Slices may lie up to a quarter of a gap beside those of `grid`:
/// a CT's need not be even, its grid is. Of a single slice the thickness does not count. What lies outside
/// theirs is 0. No value: it is no part of it.
std::optional<LabelVolume> placed_on(const LabelVolume& labels, const VolumeGrid& grid);

}  // namespace glisson
