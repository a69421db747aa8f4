// SPDX-License-Identifier: GPL-3.0-or-later
#include "overlay_layers.h"

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include "glisson/core/error.h"
#include "glisson/geometry/closest_point_tree.h"
#include "glisson/patient/label_map.h"
#include "glisson/ui/scene/pinhole_camera.h"
#include "glisson/ui/scene/surface_shapes.h"

namespace glisson::scene {
namespace {

constexpr int kTrianglesPerStructure = 20000;
/// Vessels run on outside the liver, where the model says nothing of how they move.
constexpr double kOutsideTolerance = 3e-3;

/// A surface bound to the mesh.
struct BoundShape {
  Binding binding;
  vtkSmartPointer<vtkPolyData> shape;
  vtkNew<vtkActor> actor;
};

TriangleMesh without_far_parts(const TriangleMesh& surface, const PatientModel& model) {
  const Binding binding = bind_points(model.mesh, surface.vertices, false);
  if (binding.outside.empty()) return surface;
  const ClosestPointTree skin(model.surface.mesh);
  std::vector<bool> far(static_cast<std::size_t>(surface.vertex_count()), false);
  for (const int i : binding.outside)
    far[static_cast<std::size_t>(i)] = skin.closest(surface.vertex(i), kOutsideTolerance).triangle < 0;
  std::vector<int> kept;
  for (int t = 0; t < surface.triangle_count(); ++t) {
    bool near = true;
    for (int k = 0; k < 3; ++k) near = near && !far[static_cast<std::size_t>(surface.triangles(t, k))];
    if (near) kept.push_back(t);
  }
  return select_triangles(surface, kept);
}

std::unique_ptr<BoundShape> make_shape(const PatientModel& model, const TriangleMesh& surface,
                                       Channel channel) {
  auto bound = std::make_unique<BoundShape>();
  bound->binding = bind_points(model.mesh, surface.vertices, false);
  bound->shape = make_poly_data(surface);
  add_normals(*bound->shape);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(bound->shape);
  mapper->ScalarVisibilityOff();
  bound->actor->SetMapper(mapper);
  vtkProperty& look = *bound->actor->GetProperty();
  double colour[3] = {0.0, 0.0, 0.0};
  colour[static_cast<int>(channel)] = 1.0;
  look.SetColor(colour);
  look.SetAmbient(0.4);  // so that the darkest drawn pixel is far from black: the value tells coverage too
  look.SetDiffuse(0.6);
  look.SetSpecular(0.0);
  return bound;
}

Channel channel_of(Label structure) {
  if (structure == structure::kHepaticVeins) return Channel::green;
  if (structure == structure::kArtery) return Channel::blue;
  return Channel::red;
}

}  // namespace

struct OverlayLayers::Impl {
  TetMesh mesh;
  std::vector<std::unique_ptr<BoundShape>> liver, vessels, lesions;
  vtkNew<vtkRenderer> renderer;
  std::unique_ptr<OffscreenRenderer> offscreen;

  void show(const std::vector<std::unique_ptr<BoundShape>>& group, bool visible) const {
    for (const auto& bound : group) bound->actor->SetVisibility(visible ? 1 : 0);
  }
  Raster pass(const std::vector<std::unique_ptr<BoundShape>>& group) {
    if (group.empty()) return {};
    show(group, true);
    Raster raster = offscreen->render(*renderer, true);
    show(group, false);
    return raster;
  }
};

OverlayLayers::OverlayLayers(const PatientModel& model, const Camera& pinhole)
    : impl_(std::make_unique<Impl>()) {
  require(model.mesh.tetrahedron_count() > 0, "an overlay follows a model that has a mesh");
  impl_->mesh = model.mesh;
  const auto add = [&](std::vector<std::unique_ptr<BoundShape>>& group, const TriangleMesh& surface,
                       Channel channel) {
    if (surface.triangle_count() == 0) return;
    group.push_back(make_shape(model, surface, channel));
    impl_->renderer->AddActor(group.back()->actor);
    group.back()->actor->SetVisibility(0);
  };
  add(impl_->liver, simplified(structure_surface(model, structure::kParenchyma), kTrianglesPerStructure),
      Channel::red);
  for (const Label inner : inner_structures(model)) {
    const TriangleMesh surface =
        without_far_parts(simplified(structure_surface(model, inner), kTrianglesPerStructure), model);
    add(is_lesion(inner) ? impl_->lesions : impl_->vessels, surface, channel_of(inner));
  }
  impl_->renderer->SetBackground(0.0, 0.0, 0.0);
  set_pinhole_camera(*impl_->renderer, pinhole, kNear, kFar);
  impl_->offscreen = std::make_unique<OffscreenRenderer>(pinhole.width, pinhole.height);
}

OverlayLayers::~OverlayLayers() = default;

LayerRasters OverlayLayers::draw(const Points& nodes_in_camera) {
  require(nodes_in_camera.rows() == impl_->mesh.vertex_count(),
          "the overlay's nodes are those of the model that it was made for");
  for (auto* group : {&impl_->liver, &impl_->vessels, &impl_->lesions})
    for (const auto& bound : *group)
      move_vertices(*bound->shape, bound->binding.apply(impl_->mesh, nodes_in_camera));
  return {impl_->pass(impl_->liver), impl_->pass(impl_->vessels), impl_->pass(impl_->lesions)};
}

}  // namespace glisson::scene
