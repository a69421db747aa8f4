// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/scene/drawable_model.h"

#include "glisson/core/error.h"
#include "glisson/geometry/closest_point_tree.h"
#include "glisson/patient/label_map.h"
#include "glisson/ui/scene/model_surfaces.h"

namespace glisson::scene {
namespace {

/// Vessels run on outside the liver, where the model says nothing of how they move.
constexpr double kOutsideTolerance = 3e-3;

Triangles triangles_inside(const DrawableSurface& surface, const ClosestPointTree& skin) {
  std::vector<bool> far(static_cast<std::size_t>(surface.mesh.vertex_count()), false);
  for (const int i : surface.binding.outside)
    far[static_cast<std::size_t>(i)] = skin.closest(surface.mesh.vertex(i), kOutsideTolerance).triangle < 0;
  Triangles kept(surface.mesh.triangles.rows(), 3);
  Eigen::Index count = 0;
  for (Eigen::Index t = 0; t < surface.mesh.triangles.rows(); ++t) {
    bool near = true;
    for (int k = 0; k < 3; ++k) near = near && !far[static_cast<std::size_t>(surface.mesh.triangles(t, k))];
    if (near) kept.row(count++) = surface.mesh.triangles.row(t);
  }
  return kept.topRows(count);
}

}  // namespace

std::shared_ptr<const DrawableModel> make_drawable(std::shared_ptr<const PatientModel> model, int triangles) {
  require(model != nullptr, "there is a model to draw");
  auto drawable = std::make_shared<DrawableModel>();
  std::vector<Label> labels = {structure::kParenchyma};
  for (const Label label : inner_structures(*model)) labels.push_back(label);
  labels.insert(labels.end(), {structure::kVenaCava, structure::kGallbladder});
  const bool has_mesh = model->mesh.tetrahedron_count() > 0;
  const ClosestPointTree skin(model->surface.mesh);
  for (const Label label : labels) {
    DrawableSurface surface;
    surface.structure = label;
    // The liver is large and smooth: it needs fewer triangles than branches do.
    const int most = label == structure::kParenchyma ? std::max(1, triangles * 2 / 3) : triangles;
    surface.mesh = simplified(structure_surface(*model, label), most);
    if (surface.mesh.triangle_count() == 0) continue;
    if (has_mesh) {
      surface.binding = bind_points(model->mesh, surface.mesh.vertices, false);
      // The liver itself is drawn whole: its fine surface is what the mesh was made from.
      surface.inside =
          label == structure::kParenchyma ? surface.mesh.triangles : triangles_inside(surface, skin);
    }
    drawable->surfaces.push_back(std::move(surface));
  }
  drawable->model = std::move(model);
  return drawable;
}

}  // namespace glisson::scene
