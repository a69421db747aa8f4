// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "glisson/engine/case_state.h"
#include "glisson/engine/parts/check.h"
#include "glisson/engine/parts/cloud.h"
#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/landmarks.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/registration.h"

namespace glisson::test {

/// Two tetrahedra, 0.2 m long: small, but with everything that a case can hold.
inline engine::CaseState small_case(double scale = 1.0) {
  engine::CaseState state;
  VolumeGrid grid;
  grid.size = {20, 18, 16};
  grid.spacing_mm = {1.5, 1.5, 2.0};
  grid.origin_mm = {-10.0, 20.0, -30.0};
  auto voxels = std::make_shared<std::vector<std::int16_t>>(static_cast<std::size_t>(grid.voxel_count()));
  for (std::size_t i = 0; i < voxels->size(); ++i) (*voxels)[i] = static_cast<std::int16_t>(i % 700) - 100;
  auto image = std::make_shared<Image>();
  image->grid = grid;
  image->voxels = voxels;
  state[part::image] = image;
  auto labels = std::make_shared<LabelMap>();
  labels->voxels = LabelVolume(grid);
  for (int i = 4; i < 12; ++i) labels->voxels.set({i, 5, 6}, structure::kParenchyma);
  labels->infos.push_back(
      {structure::kParenchyma, "parenchyma", "", structure_colour(structure::kParenchyma)});
  state[part::labels] = labels;
  auto built = std::make_shared<model::BuiltModel>();
  built->model.mesh.vertices.resize(5, 3);
  built->model.mesh.vertices << 0, 0, 0, 0.2, 0, 0, 0, 0.2, 0, 0, 0, 0.2, 0.2, 0.2, 0.2;
  built->model.mesh.vertices *= scale;
  built->model.mesh.tetrahedra.resize(2, 4);
  built->model.mesh.tetrahedra << 0, 1, 2, 3, 1, 4, 2, 3;
  built->model.mesh.labels = {structure::kParenchyma, structure::kFirstLesion};
  built->model.surface = boundary_surface(built->model.mesh);
  built->model.surfaces.push_back({structure::kParenchyma, "liver", built->model.surface.mesh});
  VesselTree tree;
  tree.structure = structure::kPortalVein;
  tree.nodes.resize(3, 3);
  tree.nodes << 0.01, 0.01, 0.01, 0.02, 0.02, 0.02, 0.03, 0.02, 0.02;
  tree.radii = {0.005, 0.004, 0.003};
  tree.beams = {{0, 1}, {1, 2}};
  tree.root = 0;
  built->model.vessels.push_back(tree);
  built->model.landmarks.anterior_margin = built->model.mesh.vertices.topRows(3);
  built->report.notes = {"a note"};
  // As a person left the trees: what was built had a longer one.
  built->trees_as_built = built->model.vessels;
  built->tree_edits = {{model::TreeEdit::Kind::prune, {0.02, 0.02, 0.02}}};
  state[part::model] = built;
  state[part::check] = std::make_shared<const engine::ModelCheck>(engine::ModelCheck{true});
  auto landmarks = std::make_shared<Landmarks>();
  landmarks->umbilical_notch = built->model.mesh.vertices.topRows(1);
  state[part::landmarks] = landmarks;
  auto cloud = std::make_shared<LabelledCloud>();
  cloud->points = built->model.mesh.vertices;
  cloud->features = {Feature::surface, Feature::surface, Feature::anterior_margin, Feature::surface,
                     Feature::umbilical_notch};
  state[part::cloud] = cloud;
  auto registration = std::make_shared<Registration>();
  registration->camera_from_ct.translation = {0.0, 0.0, 0.1};
  registration->nodes_in_camera = registration->camera_from_ct.apply(built->model.mesh.vertices);
  registration->termination = Termination::converged;
  registration->steps = 12;
  registration->doubts = {"few_margin_points"};
  state[part::registration] = registration;
  std::uint64_t revision = 0;
  for (const engine::Part part : engine::all_parts())
    if (state.has(part)) state.stamp(part).revision = ++revision;
  state.stamp(part::model).made_from[part::labels] = state.stamp(part::labels).revision;
  state.stamp(part::check).made_from[part::model] = state.stamp(part::model).revision;
  return state;
}

}  // namespace glisson::test
