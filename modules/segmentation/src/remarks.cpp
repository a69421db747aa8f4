// SPDX-License-Identifier: GPL-3.0-or-later
#include "remarks.h"

#include <algorithm>
#include <cmath>

#include "bright_lesions.h"
#include "glisson/patient/cut_organ.h"
#include "glisson/segmentation/kept_notes.h"
#include "part.h"

namespace glisson::segmentation {
namespace {

/// What of the hepatic veins may lie outside of the liver, ml: three trunks of 10 mm, 15 mm long, are 3.5.
constexpr double kVeinsBeyond = 5.0;
/// The same beside a vena cava that was found: its mouth and rim count, too.
constexpr double kVeinsBesideCava = 10.0;
/// Less is hardly the whole organ, ml.
constexpr double kLeastCava = 8.0;
/// A full gallbladder is up to 10 cm long and 4 cm wide: an ellipsoid of so much, ml.
constexpr double kMostGallbladder = 84.0;

double ml_of(const LabelVolume& labels, Label label) {
  const std::vector<long> counts = labels.histogram();
  return label < counts.size() ? 1e-3 * static_cast<double>(counts[label]) * labels.grid().voxel_volume_mm3()
                               : 0.0;
}

/// Without seeds of its own the vena cava is tissue like the veins that end in it, and they grow on into it;
/// so they do into what its seeds did not find of it.
/// @param liver as inside_liver() has it.
std::optional<std::string> cava_note(const LabelVolume& labels, const std::vector<std::uint8_t>& liver) {
  const bool has_cava = ml_of(labels, structure::kVenaCava) > 0.0;
  const std::vector<std::uint8_t> veins =
      labels.mask([](Label label) { return label == structure::kHepaticVeins; });
  long beyond = 0;
  for (std::size_t i = 0; i < veins.size(); ++i) beyond += veins[i] != 0 && liver[i] == 0;
  const double ml = 1e-3 * static_cast<double>(beyond) * labels.grid().voxel_volume_mm3();
  if (ml <= (has_cava ? kVeinsBesideCava : kVeinsBeyond)) return {};
  return (has_cava ? "hepatic_veins.beside_cava " : "hepatic_veins.hold_cava ") +
         std::to_string(std::lround(ml));
}

/// Where the liver ends on the region's border and none of before goes on: a flat face that is no surface.
/// @param liver as inside_liver() has it.
std::optional<std::string> region_note(const VolumeGrid& grid, const std::vector<std::uint8_t>& liver,
                                       const std::optional<Eigen::AlignedBox3d>& region) {
  if (!region) return {};
  const auto rows = cut_rows(grid, liver, [&](const Eigen::Vector3i& here, const Eigen::Vector3i& next) {
    return grid.contains(next) && is_in(region, grid, here) && !is_in(region, grid, next);
  });
  const double cut = area_mm2(grid, rows);
  if (cut < kLeastCutMm2) return {};
  return "liver.cut_by_region " + std::to_string(std::lround(1e-2 * cut));
}

/// @param liver as inside_liver() has it.
SegmentationReport report_of(const Image& image, const LabelMap& labels,
                             const std::vector<std::uint8_t>& liver, const Seeds& seeds,
                             const std::optional<Eigen::AlignedBox3d>& region) {
  SegmentationReport report;
  report.liver_ml = 1e-3 * static_cast<double>(std::count(liver.begin(), liver.end(), 1)) *
                    labels.voxels.grid().voxel_volume_mm3();
  const VolumeGrid& grid = labels.voxels.grid();
  if (auto note = cut_note(grid, image_cut(grid, liver, &image))) report.notes.push_back(std::move(*note));
  if (auto note = region_note(grid, liver, region)) report.notes.push_back(std::move(*note));
  if (auto note = cava_note(labels.voxels, liver)) report.notes.push_back(std::move(*note));
  if (looks_mirrored(labels.voxels)) report.notes.emplace_back("liver.perhaps_mirrored");
  report.portal_ml = ml_of(labels.voxels, structure::kPortalVein);
  report.hepatic_ml = ml_of(labels.voxels, structure::kHepaticVeins);
  for (std::size_t n = 0; n < seeds.lesions.size(); ++n)
    report.lesion_ml.push_back(ml_of(labels.voxels, static_cast<Label>(structure::kFirstLesion + n)));
  return report;
}

/// A vena cava that ended at once, as behind a clot, and a gallbladder that is distended or ran on into what
/// looks alike, as ascites or a cyst does. @param labels of the whole image; a region may cut either.
void note_sizes(const LabelVolume& labels, const Structures& found, SegmentationReport& report) {
  const double cava = ml_of(labels, structure::kVenaCava);
  const double gallbladder = ml_of(labels, structure::kGallbladder);
  if (found.vena_cava && cava < kLeastCava)
    report.notes.push_back("vena_cava.small " + std::to_string(std::lround(cava)));
  if (found.gallbladder && gallbladder > kMostGallbladder)
    report.notes.push_back("gallbladder.large " + std::to_string(std::lround(gallbladder)));
}

/// Codes, not sentences: what a person should look at.
/// @param found of what was asked anew.
void note_doubts(const Seeds& seeds, const Structures& anew, const Structures& found, const Bodies& bodies,
                 const Vessels& trees, SegmentationReport& report) {
  if (trees.portal_is_faint) report.notes.emplace_back("portal_vein.faint");
  if (trees.hepatic_is_faint) report.notes.emplace_back("hepatic_veins.faint");
  if (report.liver_ml < kSmallLiver) report.notes.emplace_back("liver.small");
  if (report.liver_ml > kLargeLiver) report.notes.emplace_back("liver.large");
  const auto is_missing = [&](bool Structures::*one) { return anew.*one && !(found.*one); };
  if (is_missing(&Structures::portal_vein) || (seeds.portal_vein.rows() > 0 && report.portal_ml == 0.0))
    report.notes.emplace_back("portal_vein.not_found");
  if (is_missing(&Structures::hepatic_veins) || (seeds.hepatic_veins.rows() > 0 && report.hepatic_ml == 0.0))
    report.notes.emplace_back("hepatic_veins.not_found");
  if (is_missing(&Structures::vena_cava)) report.notes.emplace_back("vena_cava.not_found");
  if (is_missing(&Structures::gallbladder)) report.notes.emplace_back("gallbladder.not_found");
  for (std::size_t n = 0; n < report.lesion_ml.size(); ++n) {
    const std::string lesion = "lesion_" + std::to_string(n + 1);
    const bool was_looked_for = n < bodies.lesions.size();
    const bool is_there = report.lesion_ml[n] > 0.0 && (!was_looked_for || is_found(bodies.lesions[n]));
    if (!is_there && seeds.lesions[n].rows() > 0) report.notes.push_back(lesion + ".not_found");
    if (!is_there || !was_looked_for) continue;
    if (bodies.lesions[n].borderless) report.notes.push_back(lesion + ".as_drawn");
    if (const int in_vain = bodies.lesions[n].clicks_in_vain; in_vain > 0)
      report.notes.push_back(lesion + ".click_without_effect " + std::to_string(in_vain));
    if (bodies.lesions[n].goes_on) report.notes.push_back(lesion + ".goes_on");
    if (bodies.lesions[n].unseen_mm > 0.0)
      report.notes.push_back(lesion + ".under_surface " +
                             std::to_string(std::lround(std::ceil(bodies.lesions[n].unseen_mm))));
  }
}

/// "CODE ML @place", where the labels have `there` at that place.
void note_body(const Painting& painting, const std::string& code, double ml, const Eigen::Vector3d& at_index,
               Label there, SegmentationReport& report) {
  if (!(ml > 0.0)) return;
  const Eigen::Vector3i last = painting.grid.size - Eigen::Vector3i::Ones();
  const Eigen::Vector3i voxel = at_index.array().round().matrix().cast<int>().cwiseMax(0).cwiseMin(last);
  if (painting.labels[static_cast<std::size_t>(painting.grid.offset(voxel))] == there)
    report.notes.push_back(code + " " + std::to_string(std::lround(ml)) +
                           place_text(painting.grid.p_in_ct(voxel.cast<double>()).xyz));
}

/// What lies at a click. Empty: it is not in the region, whose clicks alone were asked.
std::optional<Label> label_at(const Outcome& outcome, const Points& clicks, Eigen::Index n) {
  const auto voxel = voxel_in(outcome.painting.grid, outcome.region, clicks.row(n).transpose());
  if (!voxel) return {};
  return outcome.painting.labels[static_cast<std::size_t>(outcome.painting.grid.offset(*voxel))];
}

/// Clicks for the liver that the labels do not follow, by number and with the reason.
void note_liver_clicks(const Outcome& outcome, SegmentationReport& report) {
  const Points& clicks = outcome.all_seeds.liver;
  for (Eigen::Index n = 0; n < clicks.rows(); ++n) {
    const auto label = label_at(outcome, clicks, n);
    if (!label || is_in_liver(*label)) continue;
    const std::string number = " " + std::to_string(n + 1);
    if (*label != structure::kBackground)
      report.notes.push_back("seed.liver_taken" + number + " " + structure_name(*label));
    else
      report.notes.push_back("seed.liver_apart" + number);
  }
}

/// The same of those against it. A vessel in the liver counts as liver, outside of it a click says nothing of
/// it. @param whole the grid of `liver`. @param liver as inside_liver() has it.
void note_clicks_against(const Outcome& outcome, const VolumeGrid& whole,
                         const std::vector<std::uint8_t>& liver, SegmentationReport& report) {
  const Points& clicks = outcome.all_seeds.background;
  for (Eigen::Index n = 0; n < clicks.rows(); ++n) {
    const auto label = label_at(outcome, clicks, n);
    if (!label || !is_in_liver(*label)) continue;
    const bool is_new = outcome.anew.liver ||
                        (*label == structure::kPortalVein && outcome.found.portal_vein) ||
                        (*label == structure::kHepaticVeins && outcome.found.hepatic_veins);
    const auto voxel = voxel_in(whole, std::nullopt, clicks.row(n).transpose());
    const bool is_enclosed = voxel && liver[static_cast<std::size_t>(whole.offset(*voxel))] != 0;
    if (is_new && (is_enclosed || is_liver_tissue(*label)))
      report.notes.push_back("seed.not_liver_taken " + std::to_string(n + 1) + " " + structure_name(*label));
  }
}

/// Whether a label lies within some mm of a point.
bool is_beside(const Painting& painting, const Eigen::Vector3i& voxel, double reach_mm, Label label) {
  const VolumeGrid& grid = painting.grid;
  const Eigen::Vector3i reach =
      (reach_mm * grid.spacing_mm.cwiseInverse()).array().floor().matrix().cast<int>();
  for (int k = -reach.z(); k <= reach.z(); ++k)
    for (int j = -reach.y(); j <= reach.y(); ++j)
      for (int i = -reach.x(); i <= reach.x(); ++i) {
        const Eigen::Vector3i v = voxel + Eigen::Vector3i(i, j, k);
        if (grid.contains(v) && painting.labels[static_cast<std::size_t>(grid.offset(v))] == label &&
            Eigen::Vector3d(i, j, k).cwiseProduct(grid.spacing_mm).norm() <= reach_mm)
          return true;
      }
  return false;
}

/// Clicks on a tree beside which nothing of it was found, by number.
void note_tree_clicks(const Outcome& outcome, const Points& clicks, Label tree, const std::string& code,
                      SegmentationReport& report) {
  constexpr double kRounding = 1.5;  // mm: the trees are found on voxels of 1 mm
  for (Eigen::Index n = 0; n < clicks.rows(); ++n) {
    const auto voxel = voxel_in(outcome.painting.grid, outcome.region, clicks.row(n).transpose());
    if (voxel && !is_beside(outcome.painting, *voxel, kBesideVessel + kRounding, tree))
      report.notes.push_back(code + ".click_without_effect " + std::to_string(n + 1));
  }
}

}  // namespace

SegmentationReport report_on(const Image& whole, const LabelMap& labels, const Outcome& outcome) {
  const Structures &anew = outcome.anew, &found = outcome.found;
  const Seeds& all = outcome.all_seeds;
  const Bodies& bodies = outcome.bodies;
  const std::vector<std::uint8_t> liver = inside_liver(labels);
  SegmentationReport report =
      report_of(whole, labels, liver, outcome.seeds, anew.liver ? outcome.region : std::nullopt);
  note_doubts(outcome.seeds, anew, found, bodies, outcome.trees, report);
  if (found.portal_vein)
    note_tree_clicks(outcome, all.portal_vein, structure::kPortalVein, "portal_vein", report);
  if (found.hepatic_veins)
    note_tree_clicks(outcome, all.hepatic_veins, structure::kHepaticVeins, "hepatic_veins", report);
  for (std::string& note :
       bright_lesion_notes(outcome.image, outcome.painting, bodies.lesions.size(), bodies.parenchyma))
    report.notes.push_back(std::move(note));
  if (!outcome.region) note_sizes(labels.voxels, found, report);
  note_clicks_against(outcome, whole.grid, liver, report);
  if (!anew.liver) return report;
  note_body(outcome.painting, "liver.perhaps_more", bodies.doubtful.ml, bodies.doubtful.at_index,
            structure::kBackground, report);
  for (const DarkBody& body : bodies.dark)
    note_body(outcome.painting, "liver.dark_body", body.ml, body.at_index, structure::kParenchyma, report);
  note_liver_clicks(outcome, report);
  return report;
}

}  // namespace glisson::segmentation
