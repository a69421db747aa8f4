// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "glisson/atlas/atlas.h"
#include "glisson/engine/case_io.h"
#include "glisson/engine/parts/landmarks.h"
#include "glisson/engine/parts/model.h"

/// @file
/// Cases that an atlas can be built of: instances of the built-in atlas with a notch that a person placed.

namespace glisson::test {

inline std::shared_ptr<const atlas::Atlas> built_in_atlas() {
  const char* source = std::getenv("GLISSON_SOURCE_DIR");
  return std::make_shared<const atlas::Atlas>(
      atlas::read_atlas(std::filesystem::path(source != nullptr ? source : ".") / "resources/atlas"));
}

inline engine::CaseState atlas_case(const atlas::Atlas& known, int number) {
  auto built = std::make_shared<model::BuiltModel>();
  TetMesh& mesh = built->model.mesh;
  mesh.vertices.resize(4, 3);
  mesh.vertices << 0, 0, 0, 0.2, 0, 0, 0, 0.2, 0, 0, 0, 0.2;
  mesh.tetrahedra.resize(1, 4);
  mesh.tetrahedra << 0, 1, 2, 3;
  mesh.labels = {structure::kParenchyma};
  built->model.surface = boundary_surface(mesh);
  // Each bent by another share of the first modes.
  Eigen::VectorXd b = Eigen::VectorXd::Zero(known.shape.mode_count());
  for (int mode = 0; mode < std::min(3, known.shape.mode_count()); ++mode)
    b[mode] = std::sqrt(known.shape.variances[mode]) * std::sin(1.7 * number + 2.1 * mode);
  const TriangleMesh liver{known.shape.instance(b), known.triangles};
  const atlas::Places notch =
      atlas::places_of(known.mean(), known.find(atlas::Structure::umbilical_notch)->mean, 1.0);
  auto placed = std::make_shared<Landmarks>();
  placed->umbilical_notch = atlas::points_at(notch, liver, 1.0);
  built->model.surfaces.push_back({structure::kParenchyma, "liver", liver});
  engine::CaseState state;
  state[part::model] = built;
  state[part::landmarks] = placed;
  return state;
}

/// Writes so many cases, named liver_0.glisson and so on. @return their paths.
inline std::vector<std::filesystem::path> write_atlas_cases(const std::filesystem::path& folder, int count) {
  const auto known = built_in_atlas();
  std::vector<std::filesystem::path> paths;
  for (int i = 0; i < count; ++i) {
    paths.push_back(folder / ("liver_" + std::to_string(i) + ".glisson"));
    engine::save_case(paths.back(), atlas_case(*known, i), RunContext());
  }
  return paths;
}

}  // namespace glisson::test
