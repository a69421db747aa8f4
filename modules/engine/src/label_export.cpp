// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/label_export.h"

#include "glisson/core/files.h"
#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/source.h"
#include "glisson/engine/review.h"
#include "glisson/patient/segment_meaning.h"
#include "glisson/volume/dicom_segmentation.h"

namespace glisson::engine {

void write_case_labels(const std::filesystem::path& path, const CaseState& state) {
  const LabelVolume& voxels = state[part::labels]->voxels;
  std::vector<LabelInfo> infos = reviewed_infos(state);
  if (lower_extension(path) != ".dcm") {
    write_labels(path, voxels, infos);
    return;
  }
  for (LabelInfo& info : infos)
    if (info.terminology.empty()) info.terminology = structure_terminology(info.code);
  // The slices are those of the image; labels on another grid have none.
  const bool fits = state[part::image] && state[part::image]->grid.same_as(voxels.grid());
  write_dicom_labels(path, voxels, infos, fits && state[part::source] ? *state[part::source] : DicomSource());
}

}  // namespace glisson::engine
