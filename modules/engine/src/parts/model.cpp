// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/parts/model.h"

#include <nlohmann/json.hpp>

#include "case_files.h"
#include "case_reach.h"
#include "glisson/core/error.h"
#include "glisson/engine/case_io.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/landmarks.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/model/tree_edits.h"
#include "ranged.h"

namespace glisson::engine {
namespace {
namespace fs = std::filesystem;
using nlohmann::json;

constexpr LengthUnit kUnit = LengthUnit::millimetre;

/// Without an organ to compare with, what would be measured on it is left out.
json write_quality(const model::MeshQuality& quality) {
  json sheet = {{"vertices", quality.vertices},
                {"tetrahedra", quality.tetrahedra},
                {"min_dihedral_deg", quality.min_dihedral_deg},
                {"max_dihedral_deg", quality.max_dihedral_deg}};
  if (const auto& fit = quality.organ_fit)
    sheet.update({{"volume_error", fit->volume_error},
                  {"vertices_to_fine_mean_mm", fit->vertices_to_fine_mean_mm},
                  {"mesh_to_fine_mean_mm", fit->mesh_to_fine_mean_mm},
                  {"fine_to_mesh_mean_mm", fit->fine_to_mesh_mean_mm},
                  {"fine_to_mesh_max_mm", fit->fine_to_mesh_max_mm}});
  return sheet;
}

model::MeshQuality read_quality(const json& sheet) {
  model::MeshQuality quality;
  quality.vertices = sheet.at("vertices");
  quality.tetrahedra = sheet.at("tetrahedra");
  quality.min_dihedral_deg = sheet.at("min_dihedral_deg");
  quality.max_dihedral_deg = sheet.at("max_dihedral_deg");
  if (!sheet.contains("volume_error")) return quality;
  model::OrganFit fit;
  fit.volume_error = sheet.at("volume_error");
  fit.vertices_to_fine_mean_mm = sheet.at("vertices_to_fine_mean_mm");
  fit.mesh_to_fine_mean_mm = sheet.at("mesh_to_fine_mean_mm");
  fit.fine_to_mesh_mean_mm = sheet.at("fine_to_mesh_mean_mm");
  fit.fine_to_mesh_max_mm = sheet.at("fine_to_mesh_max_mm");
  // Earlier programs wrote zeros where nothing was measured; no mesh follows an organ to the last bit.
  const bool is_measured = fit.volume_error != 0.0 || fit.mesh_to_fine_mean_mm != 0.0;
  if (is_measured) quality.organ_fit = fit;
  return quality;
}

json write_model(const fs::path& folder, const model::BuiltModel& built) {
  fs::create_directory(folder / "model");
  write_tet_mesh(folder / "model/mesh.vtu", built.model.mesh, kUnit);
  write_vessels(folder / "model/vessels.vtp", built.model.vessels);
  if (!built.tree_edits.empty()) {
    write_vessels(folder / "model/vessels_as_built.vtp", built.trees_as_built);
    model::write_tree_edits(folder / "model/tree_edits.json", built.tree_edits);
  }
  if (!built.model.landmarks.empty() || built.model.landmarks.vena_cava.rows() > 0)
    write_landmarks(folder / "model/landmarks.json", built.model.landmarks);
  json surfaces = json::array();
  for (std::size_t i = 0; i < built.model.surfaces.size(); ++i) {
    const NamedSurface& surface = built.model.surfaces[i];
    const std::string name = "model/surface_" + std::to_string(i) + ".vtp";
    write_triangle_mesh(folder / name, surface.mesh, kUnit);
    surfaces.push_back({{"file", name}, {"structure", surface.structure}, {"name", surface.name}});
  }
  return {{"surfaces", surfaces},
          {"notes", built.report.notes},
          {"quality", write_quality(built.report.quality)}};
}

model::BuiltModel read_model(const fs::path& folder, const json& entry) {
  model::BuiltModel built;
  built.model.mesh = read_tet_mesh(folder / "model/mesh.vtu", kUnit);
  built.model.surface = boundary_surface(built.model.mesh);
  built.model.vessels = read_vessels(folder / "model/vessels.vtp");
  if (fs::exists(folder / "model/tree_edits.json")) {
    built.tree_edits = model::read_tree_edits(folder / "model/tree_edits.json");
    built.trees_as_built = read_vessels(folder / "model/vessels_as_built.vtp");
  }
  if (fs::exists(folder / "model/landmarks.json"))
    built.model.landmarks = read_landmarks(folder / "model/landmarks.json");
  for (const json& surface : entry.at("surfaces"))
    built.model.surfaces.push_back(
        {ranged<Label>(folder, surface, "structure", 0.0, 65535.0), surface.at("name").get<std::string>(),
         read_triangle_mesh(file_of_case(folder, "surfaces", surface.at("file").get<std::string>()), kUnit)});
  built.report.notes = entry.at("notes").get<std::vector<std::string>>();
  built.report.quality = read_quality(entry.at("quality"));
  return built;
}

bool same(const CaseState& written, const CaseState& read) {
  const PatientModel &a = written[part::model]->model, &b = read[part::model]->model;
  return same_points(a.mesh.vertices, b.mesh.vertices) && a.mesh.tetrahedra == b.mesh.tetrahedra &&
         a.vessels.size() == b.vessels.size();
}

}  // namespace

const PartOf<model::BuiltModel> part::model{
    {.code = "model",
     .made_of = {part::labels},
     .remedy = "Build or import a model first",
     .files = {"model/*.vtu", "model/*.vtp", "model/*.json"},
     .save = [](const CaseState& state,
                const CaseFolder& folder) { return write_model(folder.path, *state[part::model]); },
     .load =
         [](CaseState& state, const json& entry, const CaseFolder& folder) {
           state[part::model] = std::make_shared<const model::BuiltModel>(read_model(folder.path, entry));
         },
     .same = same}};

Landmarks effective_landmarks(const CaseState& state) {
  require(state[part::model] != nullptr, "landmarks belong to a model");
  Landmarks landmarks = state[part::model]->model.landmarks;
  if (const auto& placed = state[part::landmarks]) {
    if (placed->anterior_margin.rows() > 0) {
      landmarks.anterior_margin = placed->anterior_margin;
      landmarks.margin_deviation = placed->margin_deviation;
    }
    if (placed->umbilical_notch.rows() > 0) {
      landmarks.umbilical_notch = placed->umbilical_notch;
      landmarks.notch_deviation = placed->notch_deviation;
    }
    if (placed->vena_cava.rows() > 0) landmarks.vena_cava = placed->vena_cava;
  }
  return landmarks;
}

PatientModel effective_model(const CaseState& state) {
  PatientModel model = state[part::model]->model;
  model.landmarks = effective_landmarks(state);
  return model;
}

}  // namespace glisson::engine
