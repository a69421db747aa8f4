// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "glisson/core/run_context.h"
#include "glisson/patient/label_map.h"
#include "glisson/volume/grid.h"

/// @file
/// Labels that a file brings, whoever wrote it: what its numbers mean, and what whoever opens it must be
/// told.

namespace glisson {

/// What is known of the CT that the labels belong to.
struct LabelPlace {
  const VolumeGrid* grid = nullptr;         ///< null: there is no CT, any grid will do
  std::string frame_of_reference_uid = {};  ///< of DICOM; empty: unknown
};

struct ImportedLabels {
  LabelMap labels;
  Review review;                   ///< how far the file says that a person has come
  std::vector<std::string> notes;  ///< codes with values: "labels.by_number 2 portal_vein", ...
};

/// Reads a volume of labels, or a DICOM segmentation (on the CT's grid: empty slices need not be in it).
/// Segments of others say by code or name what they are, not by their number; numbers without a name of
/// somebody else's are Glisson's. Tumours of others that share a label become a lesion each.
/// @param codes what the file's numbers mean; empty: as above.
/// @param left_liver where it is taken, a liver that looks mirrored is a note, "liver.perhaps_mirrored".
/// @return empty: cancelled.
/// @throws InputError no parenchyma, nothing of the liver in any segment, another grid than the CT's, a liver
///   that looks mirrored; as read_labels(), read_dicom_labels().
Cancellable<ImportedLabels> import_labels(const std::filesystem::path& path, const LabelCodes& codes,
                                          LeftLiver left_liver, const LabelPlace& place,
                                          const RunContext& context);

}  // namespace glisson
