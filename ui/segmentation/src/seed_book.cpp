// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/segmentation/seed_book.h"

#include "glisson/core/error.h"
#include "glisson/patient/label_map.h"

namespace glisson::ui {
namespace {

constexpr std::array<Label, 6> kOrder = {structure::kParenchyma,   structure::kPortalVein,
                                         structure::kHepaticVeins, structure::kVenaCava,
                                         structure::kGallbladder,  structure::kBackground};

Points* points_of(segmentation::Seeds& seeds, Label structure) {
  switch (structure) {
    case structure::kParenchyma:
      return &seeds.liver;
    case structure::kPortalVein:
      return &seeds.portal_vein;
    case structure::kHepaticVeins:
      return &seeds.hepatic_veins;
    case structure::kVenaCava:
      return &seeds.vena_cava;
    case structure::kGallbladder:
      return &seeds.gallbladder;
    case structure::kBackground:
      return &seeds.background;
    default:
      break;
  }
  if (!is_lesion(structure)) return nullptr;
  const auto lesion = static_cast<std::size_t>(structure - structure::kFirstLesion);
  return lesion < seeds.lesions.size() ? &seeds.lesions[lesion] : nullptr;
}

/// It may have been drawn at the seed that goes.
void forget_diameter(segmentation::Seeds& seeds, Label lesion) {
  const auto number = static_cast<std::size_t>(lesion - structure::kFirstLesion);
  if (number < seeds.lesion_diameters_mm.size()) seeds.lesion_diameters_mm[number] = 0.0;
}

void append(std::vector<SeedEntry>& entries, const Points& points, Label structure) {
  for (Eigen::Index row = 0; row < points.rows(); ++row)
    entries.push_back({structure, static_cast<int>(row), points.row(row).transpose()});
}

}  // namespace

std::vector<SeedEntry> list_seeds(const segmentation::Seeds& seeds) {
  std::vector<SeedEntry> entries;
  segmentation::Seeds copy = seeds;
  for (const Label structure : kOrder) {
    if (structure == structure::kBackground)  // lesions stand before what is not liver
      for (std::size_t i = 0; i < seeds.lesions.size(); ++i) {
        const std::size_t first = entries.size();
        append(entries, seeds.lesions[i], static_cast<Label>(structure::kFirstLesion + i));
        for (std::size_t n = first; n < entries.size(); ++n)
          entries[n].diameter_mm = seeds.lesion_diameter_mm(i);
      }
    append(entries, *points_of(copy, structure), structure);
  }
  return entries;
}

void add_seed(segmentation::Seeds& seeds, Label structure, const Eigen::Vector3d& p_in_ct) {
  if (is_lesion(structure)) {
    const auto lists = static_cast<std::size_t>(structure - structure::kFirstLesion) + 1;
    if (seeds.lesions.size() < lists) seeds.lesions.resize(lists);
  }
  Points* points = points_of(seeds, structure);
  require(points != nullptr,
          "seeds are placed for the liver, its vessels, the gallbladder, lesions and background");
  points->conservativeResize(points->rows() + 1, 3);
  points->row(points->rows() - 1) = p_in_ct.transpose();
}

void set_diameter(segmentation::Seeds& seeds, Label lesion, double diameter_mm) {
  require(is_lesion(lesion) && count_seeds(seeds, lesion) > 0, "a lesion whose diameter is set has a seed");
  const auto number = static_cast<std::size_t>(lesion - structure::kFirstLesion);
  if (seeds.lesion_diameters_mm.size() <= number) seeds.lesion_diameters_mm.resize(number + 1, 0.0);
  seeds.lesion_diameters_mm[number] = diameter_mm;
}

void remove_seed(segmentation::Seeds& seeds, const SeedEntry& entry) {
  Points* points = points_of(seeds, entry.structure);
  require(points != nullptr && entry.row >= 0 && entry.row < points->rows(), "a seed that is removed exists");
  const Eigen::Index after = points->rows() - entry.row - 1;
  const Points tail = points->bottomRows(after);
  points->conservativeResize(points->rows() - 1, 3);
  points->bottomRows(after) = tail;
  if (is_lesion(entry.structure)) forget_diameter(seeds, entry.structure);
  while (!seeds.lesions.empty() && seeds.lesions.back().rows() == 0) seeds.lesions.pop_back();
  if (seeds.lesion_diameters_mm.size() > seeds.lesions.size())
    seeds.lesion_diameters_mm.resize(seeds.lesions.size());
}

int count_seeds(const segmentation::Seeds& seeds, Label structure) {
  segmentation::Seeds copy = seeds;
  const Points* points = points_of(copy, structure);
  return points == nullptr ? 0 : static_cast<int>(points->rows());
}

std::set<Label> lesions_to_seed(const segmentation::Seeds& seeds,
                                const segmentation::LabelStatistics* statistics) {
  std::set<Label> offered;
  for (std::size_t i = 0; i < seeds.lesions.size(); ++i)
    if (seeds.lesions[i].rows() > 0) offered.insert(static_cast<Label>(structure::kFirstLesion + i));
  std::set<Label> taken = offered;
  if (statistics != nullptr)
    for (const auto& [label, figures] : statistics->figures())
      if (figures.voxels > 0) taken.insert(label);
  const std::vector<Label> free =
      free_labels(structure::kFirstLesion, [&taken](Label label) { return taken.contains(label); });
  if (!free.empty()) offered.insert(free.front());
  return offered;
}

}  // namespace glisson::ui
