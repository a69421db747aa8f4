// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/import_labels.h"

#include <algorithm>
#include <string>
#include <vector>

#include "glisson/core/error.h"
#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/source.h"
#include "glisson/patient/segment_meaning.h"
#include "glisson/volume/dicom_segmentation.h"
#include "label_steps.h"

namespace glisson::engine {
namespace {

/// What a file says of its labels, by the labels that they become.
Review review_in(const LabelFile& file, const LabelCodes& codes) {
  Review review;
  for (const LabelInfo& info : file.infos) {
    if (!codes.empty() && !codes.contains(info.code)) continue;  // it becomes background
    const ReviewState state = review_state(info.status);
    const auto [known, is_new] = review.emplace(codes.empty() ? info.code : codes.at(info.code), state);
    // Of several that become one label, all have to be looked at.
    if (!is_new) known->second = std::min(known->second, state);
  }
  std::erase_if(review, [](const auto& one) { return one.second == ReviewState::not_started; });
  return review;
}

/// Segments of others say by code or name what they are, not by their number.
/// @param field what says so in the file. @param[out] notes name the segments that are left out: whoever
/// drew a tumour as plain tissue learns that it is missing.
/// @throws InputError none of them is anything of the liver.
LabelCodes meanings_of(const std::filesystem::path& path, const std::string& field,
                       const std::vector<LabelInfo>& segments, std::vector<std::string>& notes) {
  LabelCodes codes = codes_meant(segments);
  if (codes.empty())
    throw InputError(path.string(), field, "names nothing of the liver in any segment",
                     "Say which segment means what with --codes FILE (see 'glisson model --help')");
  std::string left_out;
  for (const LabelInfo& segment : segments)
    if (!codes.contains(segment.code))
      left_out += (left_out.empty() ? "" : ", ") +
                  (segment.name.empty() ? std::to_string(segment.code) : segment.name);
  if (!left_out.empty()) notes.push_back("labels.segments_left_out " + left_out);
  return codes;
}

/// Whether a file names its segments otherwise than Glisson names those of the same numbers. "label_7" is
/// what Glisson writes where there is no name.
bool are_named_by_others(const std::vector<LabelInfo>& segments) {
  return std::ranges::any_of(segments, [](const LabelInfo& segment) {
    return !segment.name.empty() && segment.name != structure_name(segment.code) &&
           segment.name != "label_" + std::to_string(segment.code);
  });
}

/// A volume of labels. Numbers without names of somebody else's are Glisson's. @param codes and notes as
/// below.
LabelFile read_volume(const std::filesystem::path& path, LabelCodes& codes, std::vector<std::string>& notes) {
  LabelFile file = read_labels(path);
  if (codes.empty() && are_named_by_others(file.infos))
    codes = meanings_of(path, "Segment names", file.infos, notes);
  return file;
}

/// A DICOM segmentation on the image's grid: empty slices need not be in it.
/// @param codes taken as they are where there are any.
/// @param[out] notes tell that the file is of another frame of reference: its voxels may be the CT's by
/// chance, as another scan's of the same table and field of view are. Anonymisers, too, give new frames, so
/// that the person decides.
LabelFile read_dicom(const std::filesystem::path& path, const CaseState& state, LabelCodes& codes,
                     std::vector<std::string>& notes) {
  const Image* image = state[part::image].get();
  DicomLabels labels = read_dicom_labels(path);
  const std::string theirs = labels.frame_of_reference_uid;
  const std::string ours = state[part::source] ? state[part::source]->frame_of_reference_uid : std::string();
  if (image != nullptr && !theirs.empty() && !ours.empty() && theirs != ours)
    notes.emplace_back("labels.other_frame");
  if (image != nullptr) {
    auto placed = placed_on(labels.file.voxels, image->grid);
    if (!placed)
      throw InputError(path.string(), "position",
                       "lies on other voxels than the CT (origin, spacing, direction or size)",
                       "Resample the segmentation to the CT's grid, or open the CT that it was drawn on");
    labels.file.voxels = std::move(*placed);
  }
  if (labels.own || !codes.empty()) return labels.file;
  codes = meanings_of(path, "SegmentedPropertyTypeCodeSequence (0062|000f)", labels.file.infos, notes);
  return labels.file;
}

}  // namespace

CommandTraits ImportLabels::traits() const {
  return {.code = "import_labels",
          .reads = {part::image, part::source},
          .writes = labels_and_review(),
          .notice = Notice::files};
}

Cancellable<Applied> ImportLabels::apply(const CaseState& state, const RunContext& context) const {
  context.progress(0.0, "labels.read");
  LabelCodes meanings = codes;
  std::vector<std::string> notes;
  const LabelFile file =
      has_dicom_mark(path) ? read_dicom(path, state, meanings, notes) : read_volume(path, meanings, notes);
  if (state[part::image]) require_same_grid(file.voxels.grid(), state[part::image]->grid, path.string());
  if (context.cancelled()) return {};
  if (meanings.empty()) require_not_mirrored(file.voxels, path.string());  // else recode() does
  LabelMap labels =
      meanings.empty() ? LabelMap{file.voxels, file.infos} : recode(file, meanings, path.string());
  Applied applied{state};
  applied.notes = std::move(notes);
  replace_labels(applied.state, std::move(labels), {kImportStep, 0, 0.0});
  put_review(applied.state, review_in(file, meanings));
  report_labels(applied.state, applied.figures);
  if (!applied.figures.contains("label_parenchyma_ml"))
    throw InputError(path.string(), "labels", "none of them is the liver's parenchyma",
                     "Say which code means what with --codes FILE (see 'glisson model --help')");
  return applied;
}

}  // namespace glisson::engine
