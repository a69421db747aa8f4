// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/model/build.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "anatomy.h"
#include "fit_to_surface.h"
#include "glisson/core/error.h"
#include "glisson/geometry/closest_point_tree.h"
#include "glisson/geometry/distance.h"
#include "glisson/geometry/sharpness.h"
#include "margin_search.h"
#include "mesh_to_size.h"
#include "vessels.h"

namespace glisson::model {
namespace {

constexpr double kLeastLesionInEdges = 0.6;  // diameter over the mesh's edge length
constexpr double kNearVesselMm = 4.0;
constexpr double kCavaContact = 0.005;      // metres between liver and vena cava
constexpr double kLandmarkSpacing = 0.004;  // metres, of the cava's points
/// The margin faces the feet and the belly: LPS axes.
const Eigen::Vector3d kInferiorAnterior(0.0, -1.0, -1.0);

MeshQuality quality_of(const TetMesh& mesh, const BoundarySurface& boundary, const Anatomy& anatomy) {
  MeshQuality quality;
  quality.vertices = mesh.vertex_count();
  quality.tetrahedra = mesh.tetrahedron_count();
  const Eigen::MatrixX2d angles = dihedral_angles(mesh);
  quality.min_dihedral_deg = angles.col(0).minCoeff();
  quality.max_dihedral_deg = angles.col(1).maxCoeff();
  OrganFit& fit = quality.organ_fit.emplace();
  fit.volume_error = volume(mesh) / anatomy.liver_volume - 1.0;
  fit.vertices_to_fine_mean_mm =
      1e3 * summarise(distances_to_surface(boundary.mesh.vertices, anatomy.fine_liver)).mean;
  const SurfaceDistance distance = surface_distance(boundary.mesh, anatomy.fine_liver);
  fit.mesh_to_fine_mean_mm = 1e3 * distance.forward.mean;
  fit.fine_to_mesh_mean_mm = 1e3 * distance.backward.mean;
  fit.fine_to_mesh_max_mm = 1e3 * distance.backward.maximum;
  return quality;
}

/// The liver's surface where the vena cava touches it, thinned to kLandmarkSpacing.
Points cava_contact(const TriangleMesh& liver, const TriangleMesh* cava) {
  if (cava == nullptr) return Points(0, 3);
  const ClosestPointTree tree(*cava);
  std::vector<Eigen::Vector3d> points;
  for (int v = 0; v < liver.vertex_count(); ++v) {
    const Eigen::Vector3d p = liver.vertex(v);
    if (tree.closest(p, kCavaContact).triangle < 0) continue;
    const bool near = std::any_of(points.begin(), points.end(), [&](const Eigen::Vector3d& q) {
      return (p - q).norm() < kLandmarkSpacing;
    });
    if (!near) points.push_back(p);
  }
  Points result(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i)
    result.row(static_cast<Eigen::Index>(i)) = points[i].transpose();
  return result;
}

/// Of a ball of its volume, metres.
double diameter_of(const ScalarField& lesion) { return std::cbrt(6.0 / std::numbers::pi * lesion.volume()); }

/// How much of a line (metres) lies as near to the cut as its rim makes sharp.
double length_on_cut(const Points& line, const TriangleMesh& cut) {
  const ClosestPointTree tree(cut);
  double length = 0.0;
  for (Eigen::Index i = 1; i < line.rows(); ++i) {
    const Eigen::Vector3d middle = 0.5 * (line.row(i - 1) + line.row(i)).transpose();
    if (tree.closest(middle, kSharpnessRadius).triangle >= 0)
      length += (line.row(i) - line.row(i - 1)).norm();
  }
  return length;
}

/// Notes how much would be margin if the cut were surface.
Points margin_of(const Anatomy& anatomy, std::vector<std::string>& notes) {
  const MarginSearch search(anatomy.fine_liver, kInferiorAnterior);
  if (anatomy.cut.triangle_count() > 0) {
    const Points with_cut = search.margin({});
    const double length_mm = 1e3 * length_on_cut(with_cut, anatomy.cut);
    if (length_mm >= 1.0) notes.push_back("landmarks.margin_on_cut " + shown(length_mm));
  }
  Points margin = search.margin(anatomy.cut);
  if (margin.rows() == 0) notes.push_back("landmarks.no_anterior_margin");
  return margin;
}

/// Lesions that elements of the wanted size can show become sub-domains. Smaller ones would draw most of the
/// nodes to themselves; they stay as surfaces, carried by the tetrahedra around them.
std::vector<std::pair<Label, ScalarField>> lesions_to_mesh(const Anatomy& anatomy, const MeshOptions& options,
                                                           std::vector<std::string>& notes) {
  std::vector<std::pair<Label, ScalarField>> large;
  for (const auto& lesion : anatomy.lesions)
    if (is_for_the_mesh(lesion.second, anatomy.liver_volume, options))
      large.push_back(lesion);
    else
      notes.push_back("lesion.too_small_for_the_mesh " + structure_name(lesion.first) + " mm " +
                      shown(1e3 * diameter_of(lesion.second)));
  return large;
}

/// Positive in a vessel and within kNearVesselMm of it, on samples that need not show more than that.
ScalarField around_vessel(const VesselMask& vessel) {
  const VolumeGrid& grid = vessel.grid;
  const VoxelBox box =
      bounding_box(grid.size, grid.spacing_mm, vessel.voxels, kNearVesselMm + grid.spacing_mm.maxCoeff());
  const Mask part = crop(grid.size, grid.spacing_mm, vessel.voxels, box);
  std::vector<float> values = squared_distance_mm2(part);
  for (float& value : values) value = static_cast<float>(kNearVesselMm) - std::sqrt(value);
  VolumeGrid around = grid;
  around.size = part.size;
  around.origin_mm = 1e3 * grid.p_in_ct(box.low.cast<double>()).xyz;
  return ScalarField(around, std::move(values));
}

Cancellable<BuiltModel> assemble(Anatomy anatomy, const ModelOptions& options, const RunContext& context) {
  BuiltModel built;
  PatientModel& model = built.model;
  std::vector<std::string>& notes = built.report.notes;
  notes = std::move(anatomy.notes);
  MesherInput input;
  input.body = anatomy.liver;
  input.body_label = structure::kParenchyma;
  input.inclusions = lesions_to_mesh(anatomy, options.mesh, notes);
  if (options.mesh.vessel_refinement < 1.0)
    for (const VesselMask& vessel : anatomy.vessels) input.refined.push_back(around_vessel(vessel));
  auto mesh = mesh_to_size(input, options.mesh, notes, context.part(0.0, 0.6));
  if (!mesh) return {};
  model.mesh = std::move(*mesh);
  FitTargets targets{&anatomy.fine_liver, anatomy.liver_volume, {}};
  for (const auto& [label, field] : input.inclusions) targets.inclusions.push_back({label, field.volume()});
  if (!fit_to_surface(model.mesh, targets, kLeastDihedral, context)) return {};
  model.surface = boundary_surface(model.mesh);
  for (const auto& [label, field] : input.inclusions)
    if (std::find(model.mesh.labels.begin(), model.mesh.labels.end(), static_cast<int>(label)) ==
        model.mesh.labels.end())
      notes.push_back("lesion.without_tetrahedra " + structure_name(label));

  auto trees = vessel_trees(anatomy, options, notes, context.part(0.6, 0.85));
  if (!trees) return {};
  model.vessels = std::move(*trees);
  if (options.vessels) count_vessel_nodes(model, notes);

  context.progress(0.85, "model.margin");
  model.landmarks.anterior_margin = margin_of(anatomy, notes);
  model.landmarks.vena_cava = cava_contact(anatomy.fine_liver, anatomy.vena_cava());
  if (context.cancelled()) return {};
  context.progress(0.95, "model.quality");
  built.report.quality = quality_of(model.mesh, model.surface, anatomy);
  model.surfaces = std::move(anatomy.surfaces);
  context.progress(1.0, "model.quality");
  return built;
}

/// Labels of a mesh are numbers without names: those of lesions are taken for Glisson's, all others are the
/// parenchyma. Other programs number otherwise (2 is the tumour, as often as not), so that it is told. Where
/// all are one, whichever, they part nothing: no lesion is the whole organ.
void take_labels(TetMesh& mesh, std::vector<std::string>& notes) {
  constexpr std::size_t kNamed = 12;
  const std::set<int> codes(mesh.labels.begin(), mesh.labels.end());
  const auto meant = [&codes](int code) {
    return codes.size() > 1 && is_lesion(code) ? static_cast<Label>(code) : structure::kParenchyma;
  };
  std::string told;
  std::size_t count = 0;
  for (const int code : codes)
    if (++count <= kNamed)
      told += (told.empty() ? "" : ", ") + std::to_string(code) + ' ' + structure_name(meant(code));
  if (count > 1) notes.push_back("mesh.labels_by_number " + told + (count > kNamed ? ", ..." : ""));
  for (int& label : mesh.labels) label = meant(label);
}

}  // namespace

bool is_for_the_mesh(const ScalarField& lesion, double liver_volume, const MeshOptions& options) {
  return diameter_of(lesion) >= kLeastLesionInEdges * typical_edge(liver_volume, options);
}

void count_vessel_nodes(const PatientModel& model, std::vector<std::string>& notes) {
  std::size_t outside = 0, beams = 0;
  for (const VesselTree& tree : model.vessels) {
    outside += bind_points(model.mesh, tree.nodes).outside.size();
    beams += tree.beams.size();
  }
  notes.push_back("vessels.beams " + std::to_string(beams));
  if (outside > 0) notes.push_back("vessels.nodes_outside_mesh " + std::to_string(outside));
}

void ModelOptions::validate() const {
  mesh.validate();
  if (target_beams < 1 || target_beams > 100000)
    throw InputError("model options", "target_beams", "is " + std::to_string(target_beams) + ", out of range",
                     "Ask for 1 to 100000 beams");
  if (!portal_root.allFinite() || !hepatic_root.allFinite())
    throw InputError("model options", "root", "is not a finite point", "Place it on the vessel's entrance");
}

Cancellable<BuiltModel> build_from_labels(const LabelMap& labels, const ModelOptions& options,
                                          const RunContext& context, const Image* image) {
  options.validate();
  auto anatomy = anatomy_of(labels, options, context.part(0.0, 0.2), image);
  if (!anatomy) return {};
  return assemble(std::move(*anatomy), options, context.part(0.2, 1.0));
}

Cancellable<BuiltModel> build_from_surfaces(const SurfaceSet& surfaces, const ModelOptions& options,
                                            const RunContext& context) {
  options.validate();
  auto anatomy = anatomy_of(surfaces, options, context.part(0.0, 0.2));
  if (!anatomy) return {};
  return assemble(std::move(*anatomy), options, context.part(0.2, 1.0));
}

BuiltModel build_from_mesh(TetMesh mesh) {
  BuiltModel built;
  take_labels(mesh, built.report.notes);
  built.model.mesh = std::move(mesh);
  built.model.surface = boundary_surface(built.model.mesh);
  built.model.surfaces.push_back(
      {structure::kParenchyma, structure_name(structure::kParenchyma), built.model.surface.mesh});
  built.model.landmarks.anterior_margin =
      detect_anterior_margin(built.model.surface.mesh, Eigen::Vector3d::Zero());
  const Eigen::MatrixX2d angles = dihedral_angles(built.model.mesh);
  built.report.quality.vertices = built.model.mesh.vertex_count();
  built.report.quality.tetrahedra = built.model.mesh.tetrahedron_count();
  built.report.quality.min_dihedral_deg = angles.col(0).minCoeff();
  built.report.quality.max_dihedral_deg = angles.col(1).maxCoeff();
  return built;
}

}  // namespace glisson::model
