// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/patient/label_import.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

#include "glisson/core/error.h"
#include "glisson/patient/label_summary.h"
#include "glisson/patient/lesion_pieces.h"
#include "glisson/patient/segment_meaning.h"
#include "glisson/volume/dicom_segmentation.h"
#include "glisson/volume/io.h"

namespace glisson {
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

/// The first of a list, with commas.
std::string first_of(const std::vector<std::string>& list) {
  constexpr std::size_t kNamed = 12;
  std::string text;
  for (std::size_t n = 0; n < std::min(list.size(), kNamed); ++n) text += (n > 0 ? ", " : "") + list[n];
  return list.size() > kNamed ? text + ", ..." : text;
}

/// Numbers without a name are taken for Glisson's. Other programs number otherwise: with 1 for the liver and
/// 2 for its tumours the tumours become the portal vein.
void note_numbers(const std::vector<LabelInfo>& infos, std::vector<std::string>& notes) {
  std::vector<std::string> taken;
  for (const LabelInfo& info : infos)
    if (is_nameless(info)) taken.push_back(std::to_string(info.code) + ' ' + structure_name(info.code));
  if (!taken.empty()) notes.push_back("labels.by_number " + first_of(taken));
}

/// Labels of which the codes say nothing become background: whoever forgot a tumour's code learns that it is
/// missing.
void note_left_out(const LabelFile& file, const LabelSummary& summary, const LabelCodes& codes,
                   std::vector<std::string>& notes) {
  std::vector<std::pair<double, std::string>> found;  // the largest first
  for (const Label code : summary.labels()) {
    if (codes.contains(code)) continue;
    const double ml = summary.ml(code);
    const auto info = std::ranges::find(file.infos, code, &LabelInfo::code);
    const bool is_named = info != file.infos.end() && !is_nameless(*info);
    std::array<char, 32> volume{};
    std::snprintf(volume.data(), volume.size(), " (%.1f ml)", ml);
    found.emplace_back(-ml,
                       std::to_string(code) + (is_named ? ' ' + info->name : std::string()) + volume.data());
  }
  std::ranges::sort(found);
  std::vector<std::string> left_out(found.size());
  std::ranges::transform(found, left_out.begin(), [](const auto& label) { return label.second; });
  if (!left_out.empty()) notes.push_back("labels.codes_left_out " + first_of(left_out));
}

/// A volume of labels. Numbers without names of somebody else's are Glisson's. @param codes and notes as
/// below.
Cancellable<LabelFile> read_volume(const std::filesystem::path& path, LabelCodes& codes,
                                   std::vector<std::string>& notes, const RunContext& context) {
  auto file = read_labels(path, context);
  if (!file || !codes.empty()) return file;
  if (std::ranges::any_of(file->infos, is_named_otherwise))
    codes = meanings_of(path, "Segment names", file->infos, notes);
  else
    note_numbers(file->infos, notes);
  return file;
}

/// @param codes taken as they are where there are any.
/// @param[out] notes tell that the file is of another frame of reference: its voxels may be the CT's by
/// chance, as another scan's of the same table and field of view are. Anonymisers, too, give new frames, so
/// that the person decides.
Cancellable<LabelFile> read_dicom(const std::filesystem::path& path, const LabelPlace& place,
                                  LabelCodes& codes, std::vector<std::string>& notes,
                                  const RunContext& context) {
  auto labels = read_dicom_labels(path, context);
  if (!labels) return std::nullopt;
  const std::string &theirs = labels->frame_of_reference_uid, &ours = place.frame_of_reference_uid;
  if (place.grid != nullptr && !theirs.empty() && !ours.empty() && theirs != ours)
    notes.emplace_back("labels.other_frame");
  if (place.grid != nullptr) {
    auto placed = placed_on(labels->file.voxels, *place.grid);
    if (!placed)
      throw InputError(path.string(), "position",
                       "lies on other voxels than the CT (origin, spacing, direction or size)",
                       "Resample the segmentation to the CT's grid, or open the CT that it was drawn on");
    labels->file.voxels = std::move(*placed);
  }
  if (!labels->own && codes.empty())
    codes = meanings_of(path, "SegmentedPropertyTypeCodeSequence (0062|000f)", labels->file.infos, notes);
  return std::move(labels->file);
}

/// @param[in,out] codes what is said of the numbers; then what they mean, empty: they are Glisson's.
Cancellable<LabelFile> read(const std::filesystem::path& path, const LabelPlace& place, LabelCodes& codes,
                            std::vector<std::string>& notes, const RunContext& context) {
  auto file = has_dicom_mark(path) ? read_dicom(path, place, codes, notes, context)
                                   : read_volume(path, codes, notes, context);
  if (file && place.grid != nullptr) require_same_grid(file->voxels.grid(), *place.grid, path.string());
  return file;
}

/// In files of others all tumours are often one label; Glisson's own say which is which. Each piece takes
/// over how far a person had come with the label.
void part_lesions(LabelMap& labels, Review& review, std::vector<std::string>& notes) {
  for (const LesionSplit& split : split_lesions(labels)) {
    const std::string name = structure_name(split.lesion) + ' ';
    notes.push_back("labels.lesion_split " + name + std::to_string(split.others.size() + 1));
    if (split.left > 0) notes.push_back("labels.lesion_not_split " + name + std::to_string(split.left));
    const auto state = review.find(split.lesion);
    if (state == review.end()) continue;
    for (const Label piece : split.others) review[piece] = state->second;
  }
}

/// What a file's labels become. @param meanings of its numbers; empty: they are Glisson's.
void put_labels(const LabelFile& file, const LabelSummary& summary, const LabelCodes& meanings,
                const std::string& name, ImportedLabels& imported) {
  imported.review = review_in(file, meanings);
  if (meanings.empty()) {
    imported.labels = {file.voxels, file.infos};
  } else {
    imported.labels = recode(file, summary, meanings, name);
    part_lesions(imported.labels, imported.review, imported.notes);
  }
}

void judge_side(const LabelSummary& summary, const LabelCodes& meanings, const std::string& name,
                LeftLiver left_liver, std::vector<std::string>& notes) {
  if (left_liver == LeftLiver::refused)
    require_not_mirrored(summary, meanings, name);
  else if (left_liver == LeftLiver::taken && summary.look_mirrored(meanings))
    notes.emplace_back("liver.perhaps_mirrored");
}

void require_parenchyma(const LabelSummary& summary, const LabelCodes& meanings, const std::string& name) {
  if (!summary.labels(meanings).contains(structure::kParenchyma))
    throw InputError(name, "labels", "none of them is the liver's parenchyma",
                     "Say which code means what with --codes FILE (see 'glisson model --help')");
}

}  // namespace

Cancellable<ImportedLabels> import_labels(const std::filesystem::path& path, const LabelCodes& codes,
                                          LeftLiver left_liver, const LabelPlace& place,
                                          const RunContext& context) {
  context.progress(0.0, "labels.read");
  ImportedLabels imported;
  LabelCodes meanings = codes;
  const auto read_file = read(path, place, meanings, imported.notes, context);
  if (!read_file || context.cancelled()) return {};
  const LabelFile& file = *read_file;
  const LabelSummary summary(file.voxels);
  if (!codes.empty()) note_left_out(file, summary, codes, imported.notes);
  put_labels(file, summary, meanings, path.string(), imported);
  judge_side(summary, meanings, path.string(), left_liver, imported.notes);
  require_parenchyma(summary, meanings, path.string());
  return imported;
}

}  // namespace glisson
