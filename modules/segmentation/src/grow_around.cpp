// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/segmentation/grow_around.h"

#include <algorithm>
#include <cmath>

#include "glisson/core/error.h"
#include "glisson/segmentation/kept_notes.h"
#include "lesions.h"
#include "mr_scale.h"
#include "part.h"
#include "same_click.h"

namespace glisson::segmentation {
namespace {

constexpr double kBranchReach = 45.0;  // mm around a click on a vessel
constexpr double kBeside = 14.0;       // mm beyond a lesion's reach, where the liver beside it is read

std::size_t number_of(Label lesion) { return static_cast<std::size_t>(lesion - structure::kFirstLesion); }

const Points& clicks_of(const Seeds& seeds, Label structure) {
  static const PointsIn<CtFrame> kNone(0, 3);
  if (structure == structure::kPortalVein) return seeds.portal_vein;
  if (structure == structure::kHepaticVeins) return seeds.hepatic_veins;
  return number_of(structure) < seeds.lesions.size() ? seeds.lesions[number_of(structure)] : kNone;
}

/// What is asked of segment(): the structure from its clicks, and the click itself.
struct Question {
  Seeds seeds;
  SegmentationOptions options;
  double reach_mm = 0.0;
};

Question question_of(const Seeds& seeds, const StructureClick& click, const std::vector<Label>& locked) {
  Question question;
  question.options.structures = kNoStructures;
  question.options.locked = locked;
  question.options.veins_from_cava = false;  // nobody has clicked the others
  const Points here = click.p_in_ct.xyz.transpose();
  if (is_lesion(click.structure)) {
    const std::size_t n = number_of(click.structure);
    question.seeds.lesions.assign(n + 1, PointsIn<CtFrame>(0, 3));
    const Points& known = clicks_of(seeds, click.structure);
    question.seeds.lesions[n] = holds_click(known, here.row(0)) ? known : here;
    question.seeds.lesion_diameters_mm.assign(n + 1, 0.0);
    question.seeds.lesion_diameters_mm[n] = seeds.lesion_diameter_mm(n);
    question.options.structures.lesions = true;
    question.reach_mm = lesion_reach_mm(seeds.lesion_diameter_mm(n)) + kBeside;
  } else {
    const bool portal = click.structure == structure::kPortalVein;
    (portal ? question.seeds.portal_vein : question.seeds.hepatic_veins) = here;
    (portal ? question.options.structures.portal_vein : question.options.structures.hepatic_veins) = true;
    question.reach_mm = kBranchReach;
  }
  return question;
}

void check(const Image& image, const LabelMap& labels, const StructureClick& click,
           const std::vector<Label>& locked) {
  require(grows_around(click.structure), "only vessels and lesions grow around a click");
  if (image.empty()) throw InputError("image", "", "is empty", "Import a CT or MRI first");
  require_same_grid(labels.voxels.grid(), image.grid, "labels that are corrected");
  if (!holds(image.grid, click.p_in_ct.xyz))
    throw InputError("seeds", structure_name(click.structure), "lies outside the image",
                     "Check that the seeds belong to this image and are in mm (LPS)");
  for (const Label label : {click.structure, structure::kParenchyma})
    if (is_among(locked, label))
      throw InputError("labels", structure_name(label), "is locked", "Unlock it, or click another structure");
}

void change(const Eigen::Vector3i& place, Label to, const StructureClick& click, CorrectedAround& result) {
  LabelVolume& labels = result.labels.voxels;
  labels.set(place, to);
  ++result.voxels_changed;
  const Eigen::Vector3d p = labels.grid().p_in_ct(place.cast<double>()).xyz;
  result.reach_mm = std::max(result.reach_mm, 1e3 * (p - click.p_in_ct.xyz).norm());
}

/// Makes liver of what the labels have of a lesion outside of the box: what ran on is wider than what was
/// drawn.
void clear_beyond(const VoxelBox& box, const StructureClick& click, CorrectedAround& result) {
  const LabelVolume before = result.labels.voxels;  // its bricks are shared
  for (std::size_t number = 0; number < before.brick_count(); ++number) {
    const auto& brick = before.brick(number);
    if (!brick || std::find(brick->begin(), brick->end(), click.structure) == brick->end()) continue;
    const Eigen::Vector3i low = LabelVolume::kSide * before.brick_place(number),
                          high = (low.array() + LabelVolume::kSide).matrix().cwiseMin(before.grid().size);
    for (int k = low.z(); k < high.z(); ++k)
      for (int j = low.y(); j < high.y(); ++j)
        for (int i = low.x(); i < high.x(); ++i) {
          const Eigen::Vector3i place(i, j, k);
          const bool is_in_box =
              (place.array() >= box.low.array()).all() && (place.array() < box.high.array()).all();
          if (!is_in_box && before.at(place) == click.structure)
            change(place, structure::kParenchyma, click, result);
        }
  }
}

/// What the search in the part says of the structure, but for what it can tell of the whole alone: of its
/// few labels the liver is small, and the vena cava may lie beside it. The click has its number in the seeds.
std::vector<std::string> notes_of(const std::vector<std::string>& told, const StructureClick& click,
                                  const Seeds& seeds) {
  const std::string code = structure_name(click.structure);
  const std::string in_vain = code + ".click_without_effect ";
  std::vector<std::string> notes;
  for (const std::string& note : told) {
    if (note.rfind(code + ".", 0) != 0 || is_told_of_the_whole(note)) continue;
    const bool numbered = !is_lesion(click.structure) && note.rfind(in_vain, 0) == 0;
    notes.push_back(numbered ? in_vain + std::to_string(click_number(clicks_of(seeds, click.structure),
                                                                     click.p_in_ct.xyz.transpose()))
                             : note);
  }
  return notes;
}

/// Whether the click has led to anything.
bool has_effect(const std::vector<std::string>& notes, const StructureClick& click) {
  const std::string code = structure_name(click.structure);
  return std::none_of(notes.begin(), notes.end(), [&](const std::string& note) {
    return note == code + ".not_found" ||
           (!is_lesion(click.structure) && note.rfind(code + ".click_without_effect", 0) == 0);
  });
}

/// Puts what was found in a part of the image into the labels.
void paste(const LabelMap& found, const VoxelBox& box, const StructureClick& click, CorrectedAround& result) {
  const LabelVolume& labels = result.labels.voxels;
  const bool only_gains = !is_lesion(click.structure);
  for (int k = box.low.z(); k < box.high.z(); ++k)
    for (int j = box.low.y(); j < box.high.y(); ++j)
      for (int i = box.low.x(); i < box.high.x(); ++i) {
        const Eigen::Vector3i place(i, j, k);
        const Label now = found.voxels.at(place - box.low), before = labels.at(place);
        if (now != before && (!only_gains || now == click.structure)) change(place, now, click, result);
      }
  if (!only_gains) clear_beyond(box, click, result);
}

}  // namespace

bool grows_around(Label structure) {
  return structure == structure::kPortalVein || structure == structure::kHepaticVeins || is_lesion(structure);
}

std::vector<StructureClick> structure_clicks_added(const Seeds& before, const Seeds& after) {
  std::vector<StructureClick> added;
  const auto add = [&](Label structure) {
    const Points &old = clicks_of(before, structure), &now = clicks_of(after, structure);
    const std::size_t count = added.size();
    for (Eigen::Index n = 0; n < now.rows(); ++n)
      if (!holds_click(old, now.row(n)))
        added.push_back({structure, Point<CtFrame>(Eigen::Vector3d(now.row(n).transpose()))});
    if (!is_lesion(structure) || added.size() > count || now.rows() == 0) return;
    if (before.lesion_diameter_mm(number_of(structure)) != after.lesion_diameter_mm(number_of(structure)))
      added.push_back({structure, Point<CtFrame>(Eigen::Vector3d(now.row(now.rows() - 1).transpose()))});
  };
  add(structure::kPortalVein);
  add(structure::kHepaticVeins);
  for (std::size_t n = 0; n < after.lesions.size(); ++n) add(static_cast<Label>(structure::kFirstLesion + n));
  return added;
}

Cancellable<CorrectedAround> grow_around(const Image& image, const LabelMap& labels, const Seeds& seeds,
                                         const StructureClick& click, const std::vector<Label>& locked,
                                         const RunContext& context) {
  check(image, labels, click, locked);
  CorrectedAround result{labels, 0.0, 0, {}};
  const Question question = question_of(seeds, click, locked);
  const VoxelBox box =
      box_around(image.grid,
                 is_lesion(click.structure) ? question.seeds.lesions[number_of(click.structure)]
                                            : Points(click.p_in_ct.xyz.transpose()),
                 question.reach_mm);
  const LabelMap kept = part_of(labels, box);
  const std::vector<long> there = kept.voxels.histogram();
  if (there.size() <= structure::kParenchyma || there[structure::kParenchyma] == 0) {
    result.notes.push_back(structure_name(click.structure) + ".not_found");
    return result;
  }
  // By the whole of an MRI: the part around a click may hold neither fat nor air.
  const double scaled = image.modality == Modality::ct ? 0.0 : 0.5;
  const auto on_scale = on_ct_scale(image, question.seeds, &labels, context.part(0.0, scaled));
  if (!on_scale) return std::nullopt;
  const auto found =
      segment(part_of(*on_scale, box), question.seeds, question.options, context.part(scaled, 1.0), &kept);
  if (!found) return std::nullopt;
  result.notes = notes_of(found->report.notes, click, seeds);
  if (!has_effect(result.notes, click)) return result;
  paste(found->labels, box, click, result);
  if (result.voxels_changed > 0) name_structure(click.structure, result.labels);
  return result;
}

}  // namespace glisson::segmentation
