// SPDX-License-Identifier: GPL-3.0-or-later
// From the labels to the model, and what a person marks: import of images and models, seeds, landmarks.
#include <Eigen/Dense>
#include <cmath>

#include "apply_parts.h"
#include "glisson/core/error.h"
#include "glisson/engine/unapproved.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/model/quality.h"
#include "glisson/model/tree_edits.h"

namespace glisson::engine {
namespace {

constexpr double kLesionToCount = 1e-6;  // m3: an error of a smaller lesion's volume says little

/// Landmarks and a mesh that came from elsewhere leave nothing of the former patient behind.
Applied with_model(const CaseState& state, model::BuiltModel built) {
  Applied applied;
  applied.state = state;
  const model::MeshQuality& quality = built.report.quality;
  const PatientModel& model = built.model;
  applied.figures["model_vertices"] = model.mesh.vertex_count();
  applied.figures["model_tetrahedra"] = model.mesh.tetrahedron_count();
  applied.figures["model_volume_ml"] = 1e6 * volume(model.mesh);
  applied.figures["model_min_dihedral_deg"] = quality.min_dihedral_deg;
  applied.figures["model_volume_error"] = quality.volume_error;
  applied.figures["model_vertices_to_fine_mean_mm"] = quality.vertices_to_fine_mean_mm;
  applied.figures["model_fine_to_mesh_mean_mm"] = quality.fine_to_mesh_mean_mm;
  applied.figures["model_fine_to_mesh_max_mm"] = quality.fine_to_mesh_max_mm;
  double beams = 0.0;
  for (const VesselTree& tree : model.vessels) beams += static_cast<double>(tree.beams.size());
  applied.figures["model_beams"] = beams;
  applied.figures["model_lesions"] = static_cast<double>(lesion_centres(model).size());
  applied.figures["model_edge_mean_mm"] = 1e3 * model::mean_edge_length(model.mesh);
  double worst = 0.0;
  for (const model::LesionVolume& lesion : model::lesion_volumes(model))
    if (lesion.volume > kLesionToCount && lesion.mesh_volume > 0.0)
      worst = std::max(worst, std::abs(lesion.mesh_volume / lesion.volume - 1.0));
  applied.figures["model_lesion_volume_error_max"] = worst;
  applied.notes = built.report.notes;
  applied.state.model = std::make_shared<const model::BuiltModel>(std::move(built));
  return applied;
}

}  // namespace

Cancellable<Applied> apply_one(const CaseState& state, const ImportImage& command,
                               const RunContext& context) {
  auto image = read_image(command.path, context, command.series);
  if (!image) return {};
  Applied applied;
  if (!command.new_case) applied.state = state;
  for (int k = 0; k < 3; ++k) {
    const std::string axis(1, static_cast<char>('i' + k));
    applied.figures["image_size_" + axis] = image->grid.size[k];
    applied.figures["image_spacing_" + axis + "_mm"] = image->grid.spacing_mm[k];
  }
  applied.state.image = std::make_shared<const Image>(std::move(*image));
  return applied;
}

Cancellable<Applied> apply_one(const CaseState& state, const ListSeries& command, const RunContext& context) {
  auto series = list_series(command.path, context);
  if (!series) return {};
  Applied applied;
  applied.state = state;
  applied.series = std::move(*series);
  return applied;
}

Cancellable<Applied> apply_one(const CaseState& state, const SetSeeds& command, const RunContext&) {
  Applied applied;
  applied.state = state;
  applied.state.seeds = std::make_shared<const segmentation::Seeds>(command.seeds);
  return applied;
}

Cancellable<Applied> apply_one(const CaseState& state, const BuildModel& command, const RunContext& context) {
  require_part(state, Part::labels, "Segment the CT or import labels first");
  auto built = model::build_from_labels(*state.labels, command.options, context);
  if (!built) return {};
  Applied applied = with_model(state, std::move(*built));
  // Not in the model's own notes: a label may be approved later.
  for (std::string& note : unapproved_notes(state)) applied.notes.push_back(std::move(note));
  return applied;
}

Cancellable<Applied> apply_one(const CaseState& state, const ImportSurfaces& command,
                               const RunContext& context) {
  const model::SurfaceSet surfaces = model::read_surfaces(command.path, command.unit);
  auto built = model::build_from_surfaces(surfaces, command.options, context);
  if (!built) return {};
  return with_model(state, std::move(*built));
}

Cancellable<Applied> apply_one(const CaseState& state, const ImportMesh& command, const RunContext& context) {
  context.progress(0.0, "mesh.read");
  model::BuiltModel built;
  built.model.mesh = read_tet_mesh(command.path, command.unit);
  check_liver_size(built.model.mesh.vertices, command.unit, command.path.string());
  built.model.surface = boundary_surface(built.model.mesh);
  built.model.surfaces.push_back(
      {structure::kParenchyma, structure_name(structure::kParenchyma), built.model.surface.mesh});
  built.model.landmarks.anterior_margin =
      model::detect_anterior_margin(built.model.surface.mesh, Eigen::Vector3d::Zero());
  const Eigen::MatrixX2d angles = dihedral_angles(built.model.mesh);
  built.report.quality.vertices = built.model.mesh.vertex_count();
  built.report.quality.tetrahedra = built.model.mesh.tetrahedron_count();
  built.report.quality.min_dihedral_deg = angles.col(0).minCoeff();
  built.report.quality.max_dihedral_deg = angles.col(1).maxCoeff();
  return with_model(state, std::move(built));
}

Cancellable<Applied> apply_one(const CaseState& state, const EditTrees& command, const RunContext&) {
  require_part(state, Part::model, "Build or import a model first: its vessel trees are edited");
  return with_model(state, model::with_tree_edits(*state.model, command.edits));
}

Cancellable<Applied> apply_one(const CaseState& state, const CheckModel& command, const RunContext&) {
  require_part(state, Part::model, "Build or import a model first");
  Applied applied;
  applied.state = state;
  applied.state.check = std::make_shared<const ModelCheck>(command.check);
  return applied;
}

Cancellable<Applied> apply_one(const CaseState& state, const SetLandmarks& command, const RunContext&) {
  require_part(state, Part::model, "Build or import a model first: landmarks lie on its surface");
  Applied applied;
  applied.state = state;
  // None at all is as if nobody had said anything: a part that holds nothing could not be saved.
  const bool none = command.landmarks.empty() && command.landmarks.vena_cava.rows() == 0;
  applied.state.landmarks = none ? nullptr : std::make_shared<const Landmarks>(command.landmarks);
  return applied;
}

}  // namespace glisson::engine
