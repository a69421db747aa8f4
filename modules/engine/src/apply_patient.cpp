// SPDX-License-Identifier: GPL-3.0-or-later
// From the CT to the model: import, segmentation, mesh, landmarks.
#include <Eigen/Dense>
#include <cmath>

#include "apply_parts.h"
#include "glisson/core/error.h"
#include "glisson/geometry/mesh_io.h"

namespace glisson::engine {
namespace {

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
  applied.notes = built.report.notes;
  applied.state.model = std::make_shared<const model::BuiltModel>(std::move(built));
  return applied;
}

void report_labels(const LabelMap& labels, Figures& figures) {
  const double voxel_ml = 1e-3 * labels.voxels.grid().voxel_volume_mm3();
  const std::vector<long> histogram = labels.voxels.histogram();
  for (std::size_t label = 1; label < histogram.size(); ++label)
    if (histogram[label] > 0)
      figures["label_" + structure_name(static_cast<Label>(label)) + "_ml"] =
          static_cast<double>(histogram[label]) * voxel_ml;
}

}  // namespace

Cancellable<Applied> apply_one(const CaseState& state, const ImportImage& command,
                               const RunContext& context) {
  auto image = read_image(command.path, context);
  if (!image) return {};
  Applied applied;
  applied.state = state;
  for (int k = 0; k < 3; ++k) {
    const std::string axis(1, static_cast<char>('i' + k));
    applied.figures["image_size_" + axis] = image->grid.size[k];
    applied.figures["image_spacing_" + axis + "_mm"] = image->grid.spacing_mm[k];
  }
  applied.state.image = std::make_shared<const Image>(std::move(*image));
  return applied;
}

Cancellable<Applied> apply_one(const CaseState& state, const ImportLabels& command,
                               const RunContext& context) {
  context.progress(0.0, "labels.read");
  const LabelFile file = read_labels(command.path);
  if (state.image) require_same_grid(file.voxels.grid(), state.image->grid, command.path.string());
  if (context.cancelled()) return {};
  Applied applied;
  applied.state = state;
  LabelMap labels = command.codes.empty() ? LabelMap{file.voxels, file.infos}
                                          : recode(file, command.codes, command.path.string());
  report_labels(labels, applied.figures);
  if (!applied.figures.contains("label_parenchyma_ml"))
    throw InputError(command.path.string(), "labels", "none of them is the liver's parenchyma",
                     "Say which code means what with --codes FILE (see 'glisson model --help')");
  applied.state.labels = std::make_shared<const LabelMap>(std::move(labels));
  return applied;
}

Cancellable<Applied> apply_one(const CaseState& state, const SetSeeds& command, const RunContext&) {
  Applied applied;
  applied.state = state;
  applied.state.seeds = std::make_shared<const segmentation::Seeds>(command.seeds);
  return applied;
}

Cancellable<Applied> apply_one(const CaseState& state, const Segment& command, const RunContext& context) {
  require_part(state, Part::image, "Import a CT first");
  require_part(state, Part::seeds, "Click seeds in the liver first, or give --seeds FILE");
  auto segmented = segmentation::segment(*state.image, *state.seeds, command.options, context);
  if (!segmented) return {};
  Applied applied;
  applied.state = state;
  report_labels(segmented->labels, applied.figures);
  applied.notes = segmented->report.notes;
  applied.state.labels = std::make_shared<const LabelMap>(std::move(segmented->labels));
  return applied;
}

Cancellable<Applied> apply_one(const CaseState& state, const BuildModel& command, const RunContext& context) {
  require_part(state, Part::labels, "Segment the CT or import labels first");
  auto built = model::build_from_labels(*state.labels, command.options, context);
  if (!built) return {};
  return with_model(state, std::move(*built));
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

Cancellable<Applied> apply_one(const CaseState& state, const SetLandmarks& command, const RunContext&) {
  require_part(state, Part::model, "Build or import a model first: landmarks lie on its surface");
  Applied applied;
  applied.state = state;
  applied.state.landmarks = std::make_shared<const Landmarks>(command.landmarks);
  return applied;
}

}  // namespace glisson::engine
