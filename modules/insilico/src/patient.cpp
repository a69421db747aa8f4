// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/insilico/patient.h"

#include <string>

#include "ct_scene.h"
#include "glisson/core/error.h"
#include "patient_surfaces.h"
#include "tissue.h"

namespace glisson::insilico {

namespace {

void check(bool good, const char* field, double value, const char* range) {
  if (good) return;
  throw InputError("PatientOptions", field, "is " + std::to_string(value), std::string("choose ") + range);
}

/// Two lesions: one of about 25 mm in the right lobe, one of about 15 mm where there is room, both clear of
/// the capsule, the main vessels and each other.
std::vector<Lesion> place_lesions(const LiverShape& shape, const GrowthOptions& growth) {
  Dice dice(RunContext({}, nullptr, shape.parameters().seed).random("insilico.lesions"));
  const GrownTrees main = main_branches(shape, growth);
  std::vector<Lesion> lesions;
  for (const double diameter : {25.0, 15.0}) {
    const double radius = 0.5 * diameter * dice.between(0.94, 1.06);
    Lesion best;
    double best_room = -1e9;
    for (int attempt = 0; attempt < 400; ++attempt) {
      Lesion lesion;
      lesion.centre = dice.inside(shape.low(), shape.high());
      const double a = dice.between(0.90, 1.10), b = dice.between(0.90, 1.10);
      lesion.half_axes = radius * Vec(a, b, 1.0 / (a * b));
      lesion.phase = dice.between(0.0, 6.0);
      double room = -shape.liver(lesion.centre) - lesion.reach() - 6.0;
      for (const GrownTree* tree : {&main.portal, &main.hepatic})
        for (std::size_t i = 0; i < tree->nodes.size(); ++i)
          room =
              std::min(room, (tree->nodes[i] - lesion.centre).norm() - tree->radii[i] - lesion.reach() - 4.0);
      for (const Lesion& other : lesions)
        room = std::min(room, (other.centre - lesion.centre).norm() - other.reach() - lesion.reach() - 30.0);
      if (room > best_room) {
        best_room = room;
        best = lesion;
      }
      if (room > 0.0) break;
    }
    lesions.push_back(best);
  }
  return lesions;
}

Points to_points(const std::vector<Vec>& millimetres) {
  Points points(static_cast<Eigen::Index>(millimetres.size()), 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    points.row(i) = 1e-3 * millimetres[static_cast<std::size_t>(i)].transpose();
  return points;
}

VesselTree to_vessel_tree(const GrownTree& grown, Label structure) {
  VesselTree tree;
  tree.structure = structure;
  tree.nodes = to_points(grown.nodes);
  tree.root = 0;
  for (std::size_t i = 0; i < grown.nodes.size(); ++i) {
    tree.radii.push_back(1e-3 * grown.radii[i]);
    if (grown.parents[i] >= 0) tree.beams.push_back({grown.parents[i], static_cast<int>(i)});
  }
  return tree;
}

/// Points of the liver's surface that lie on the vena cava, about 6 mm apart.
Points cava_contact(const LiverShape& shape, const TriangleMesh& liver) {
  std::vector<Vec> chosen;
  for (int i = 0; i < liver.vertex_count(); ++i) {
    const Vec p = 1e3 * liver.vertex(i);
    if (shape.cava(p) > 1.0 || p.z() > kCavaTop) continue;
    const bool apart =
        std::all_of(chosen.begin(), chosen.end(), [&](const Vec& other) { return (p - other).norm() > 6.0; });
    if (apart) chosen.push_back(p);
  }
  return to_points(chosen);
}

void add_surfaces(SyntheticPatient& patient, const Anatomy& anatomy, double spacing) {
  const LiverShape& shape = anatomy.shape;
  const auto add = [&](Label structure, TriangleMesh mesh) {
    const std::string name = structure == structure::kParenchyma ? "liver" : structure_name(structure);
    patient.surfaces.push_back({structure, name, std::move(mesh)});
  };
  add(structure::kParenchyma,
      contour(shape.low(), shape.high(), spacing, [&](const Vec& p) { return shape.liver(p); }));
  for (std::size_t i = 0; i < anatomy.lesions.size(); ++i) {
    const Lesion& lesion = anatomy.lesions[i];
    const Vec reach = Vec::Constant(lesion.reach() + 4.0);
    add(static_cast<Label>(structure::kFirstLesion + i),
        contour(lesion.centre - reach, lesion.centre + reach, std::min(spacing, 1.0),
                [&](const Vec& p) { return lesion.field(p); }));
  }
  const VolumeGrid& ct = patient.ct.grid;
  const double bottom = ct.origin_mm.z() + 2.0;
  add(structure::kVenaCava, contour({-60, -20, bottom - 3.0 * spacing}, {20, 60, kCavaTop + 3.0 * spacing},
                                    spacing, [&](const Vec& p) {
                                      return std::max({shape.cava(p), p.z() - kCavaTop, bottom - p.z()});
                                    }));
  add(structure::kGallbladder,
      contour(shape.low(), shape.high(), spacing, [&](const Vec& p) { return shape.gallbladder(p); }));
  // Thin branches need samples finer than their radius.
  const double fine = std::min(0.53 * spacing, 1.0);
  add(structure::kPortalVein, contour(anatomy.trees.portal, fine));
  add(structure::kHepaticVeins, contour(anatomy.trees.hepatic, fine));
}

}  // namespace

std::vector<LabelInfo> label_infos(std::size_t lesions) {
  std::vector<Label> labels = {structure::kParenchyma, structure::kPortalVein, structure::kHepaticVeins,
                               structure::kVenaCava, structure::kGallbladder};
  for (std::size_t i = 0; i < lesions; ++i) labels.push_back(static_cast<Label>(structure::kFirstLesion + i));
  std::vector<LabelInfo> infos;
  infos.reserve(labels.size());
  for (const Label label : labels) infos.push_back(structure_info(label));
  return infos;
}

Cancellable<Anatomy> draw_anatomy(std::uint64_t shape_seed, const RunContext& context) {
  LiverShape shape(draw_shape(shape_seed));
  const GrowthOptions growth;
  std::vector<Lesion> lesions = place_lesions(shape, growth);
  auto trees = grow_trees(shape, lesions, growth, context);
  if (!trees) return {};
  return Anatomy{std::move(shape), std::move(lesions), std::move(*trees)};
}

void PatientOptions::validate() const {
  for (int a = 0; a < 3; ++a)
    check(spacing_mm[a] >= 0.4 && spacing_mm[a] <= 12.0, "spacing_mm", spacing_mm[a], "0.4 to 12 mm");
  check(noise_hu >= 0.0 && noise_hu <= 200.0, "noise_hu", noise_hu, "0 to 200 HU");
  check(blur_mm >= 0.0 && blur_mm <= 10.0, "blur_mm", blur_mm, "0 to 10 mm");
  check(surface_spacing_mm >= 0.4 && surface_spacing_mm <= 4.0, "surface_spacing_mm", surface_spacing_mm,
        "0.4 to 4 mm");
}

Cancellable<SyntheticPatient> make_patient(const PatientOptions& options, const RunContext& context) {
  options.validate();
  context.progress(0.0, "patient.shape");
  const auto drawn = draw_anatomy(options.shape_seed, context.part(0.05, 0.15));
  if (!drawn) return {};
  const Anatomy& anatomy = *drawn;

  SyntheticPatient patient;
  patient.ct.grid = ct_grid(options.spacing_mm);
  patient.ct.description =
      "Synthetic patient " + std::to_string(options.shape_seed) + ", portal venous phase";
  Canvas canvas(patient.ct.grid, -1000.0F);
  std::vector<Label> labels;
  if (!paint_trunk(canvas, anatomy.shape, context.part(0.15, 0.45))) return {};
  if (!paint_organs(canvas, anatomy.shape, context.part(0.45, 0.60))) return {};
  if (!paint_liver(canvas, anatomy, labels, context.part(0.60, 0.75))) return {};
  patient.truth.voxels = LabelVolume(patient.ct.grid, labels);
  patient.truth.infos = label_infos(anatomy.lesions.size());
  context.progress(0.75, "patient.scan");
  patient.ct.voxels = std::make_shared<const std::vector<std::int16_t>>(
      scan(canvas, options.blur_mm, options.noise_hu, options.shape_seed));
  if (context.cancelled()) return {};

  context.progress(0.85, "patient.surfaces");
  add_surfaces(patient, anatomy, options.surface_spacing_mm);
  if (context.cancelled()) return {};
  patient.landmarks.anterior_margin = to_points(anatomy.shape.anterior_margin(3.0));
  patient.landmarks.umbilical_notch = to_points({anatomy.shape.umbilical_notch()});
  patient.landmarks.vena_cava = cava_contact(anatomy.shape, patient.surfaces.front().mesh);
  patient.trees = {to_vessel_tree(anatomy.trees.portal, structure::kPortalVein),
                   to_vessel_tree(anatomy.trees.hepatic, structure::kHepaticVeins)};
  context.progress(1.0, "patient.surfaces");
  return patient;
}

}  // namespace glisson::insilico
