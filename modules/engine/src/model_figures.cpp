// SPDX-License-Identifier: GPL-3.0-or-later
#include "model_figures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "glisson/engine/parts/model.h"
#include "glisson/fem/composite_model.h"
#include "glisson/model/quality.h"

namespace glisson::engine {
namespace {

/// Of the beams. A patient's trunks before the liver are 4 %; labels whose codes mean something else, 80 %.
constexpr double kNotableShare = 0.25;
constexpr const char* kOutside = "vessels.beams_outside ";
constexpr double kLesionToCount = 1e-6;  // m3: an error of a smaller lesion's volume says little

Figures figures_of(const model::BuiltModel& built, const fem::BoundVessels& vessels) {
  Figures figures;
  const model::MeshQuality& quality = built.report.quality;
  const PatientModel& model = built.model;
  figures["model_vertices"] = model.mesh.vertex_count();
  figures["model_tetrahedra"] = model.mesh.tetrahedron_count();
  figures["model_volume_ml"] = 1e6 * volume(model.mesh);
  figures["model_min_dihedral_deg"] = quality.min_dihedral_deg;
  if (const auto& fit = quality.organ_fit) {
    figures["model_volume_error"] = fit->volume_error;
    figures["model_vertices_to_fine_mean_mm"] = fit->vertices_to_fine_mean_mm;
    figures["model_fine_to_mesh_mean_mm"] = fit->fine_to_mesh_mean_mm;
    figures["model_fine_to_mesh_max_mm"] = fit->fine_to_mesh_max_mm;
  }
  double beams = 0.0;
  for (const VesselTree& tree : model.vessels) beams += static_cast<double>(tree.beams.size());
  figures["model_beams"] = beams;
  figures["model_beams_outside"] = vessels.beams_dropped;
  figures["model_vessel_nodes_outside"] = vessels.nodes_outside;
  figures["model_lesions"] = static_cast<double>(lesion_centres(model).size());
  figures["model_edge_mean_mm"] = 1e3 * model::mean_edge_length(model.mesh);
  double worst = std::numeric_limits<double>::quiet_NaN();  // of none
  for (const model::LesionVolume& lesion : model::lesion_volumes(model))
    if (lesion.volume > kLesionToCount && lesion.mesh_volume > 0.0)
      worst = std::fmax(worst, std::abs(lesion.mesh_volume / lesion.volume - 1.0));
  if (std::isfinite(worst)) figures["model_lesion_volume_error_max"] = worst;
  return figures;
}

/// Said of the trees as they are now: those of before may have been edited.
void note_beams_outside(const fem::BoundVessels& vessels, std::vector<std::string>& notes) {
  std::erase_if(notes, [](const std::string& note) { return note.starts_with(kOutside); });
  const int all = vessels.beams + vessels.beams_dropped;
  if (vessels.beams_dropped > kNotableShare * all)
    notes.push_back(kOutside + std::to_string(vessels.beams_dropped) + " " + std::to_string(all));
}

}  // namespace

Applied with_model(const CaseState& state, model::BuiltModel built) {
  const fem::BoundVessels vessels = fem::bound_vessels(built.model.mesh, built.model.vessels);
  note_beams_outside(vessels, built.report.notes);
  Applied applied{state, figures_of(built, vessels), built.report.notes};
  applied.state[part::model] = std::make_shared<const model::BuiltModel>(std::move(built));
  return applied;
}

}  // namespace glisson::engine
