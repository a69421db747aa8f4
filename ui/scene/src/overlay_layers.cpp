// SPDX-License-Identifier: GPL-3.0-or-later
#include "overlay_layers.h"

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include "glisson/core/error.h"
#include "glisson/patient/label_map.h"
#include "glisson/ui/scene/pinhole_camera.h"
#include "glisson/ui/scene/surface_shapes.h"

namespace glisson::scene {
namespace {

/// A surface as VTK holds it.
struct BoundShape {
  const DrawableSurface* surface = nullptr;
  vtkSmartPointer<vtkPolyData> shape;
  vtkNew<vtkActor> actor;
};

std::unique_ptr<BoundShape> make_shape(const DrawableSurface& surface, Channel channel) {
  auto bound = std::make_unique<BoundShape>();
  bound->surface = &surface;
  bound->shape = make_poly_data({surface.mesh.vertices, surface.inside});
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

bool is_vessel(Label structure) {
  return structure == structure::kPortalVein || structure == structure::kHepaticVeins ||
         structure == structure::kArtery;
}

Channel channel_of(Label structure) {
  if (structure == structure::kHepaticVeins) return Channel::green;
  if (structure == structure::kArtery) return Channel::blue;
  return Channel::red;
}

}  // namespace

struct OverlayLayers::Impl {
  std::shared_ptr<const DrawableModel> model;
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

OverlayLayers::OverlayLayers(std::shared_ptr<const DrawableModel> model, const Camera& pinhole)
    : impl_(std::make_unique<Impl>()) {
  require(model != nullptr && model->model->mesh.tetrahedron_count() > 0,
          "an overlay follows a model that has a mesh");
  impl_->model = std::move(model);
  for (const DrawableSurface& surface : impl_->model->surfaces) {
    auto* group = surface.structure == structure::kParenchyma ? &impl_->liver
                  : is_lesion(surface.structure)              ? &impl_->lesions
                  : is_vessel(surface.structure)              ? &impl_->vessels
                                                              : nullptr;
    if (group == nullptr || surface.inside.rows() == 0) continue;
    group->push_back(make_shape(surface, channel_of(surface.structure)));
    impl_->renderer->AddActor(group->back()->actor);
    group->back()->actor->SetVisibility(0);
  }
  impl_->renderer->SetBackground(0.0, 0.0, 0.0);
  set_pinhole_camera(*impl_->renderer, pinhole, kNear, kFar);
  impl_->offscreen = std::make_unique<OffscreenRenderer>(pinhole.width, pinhole.height);
}

OverlayLayers::~OverlayLayers() = default;

LayerRasters OverlayLayers::draw(const Points& nodes_in_camera) {
  require(nodes_in_camera.rows() == impl_->model->model->mesh.vertex_count(),
          "the overlay's nodes are those of the model that it was made for");
  for (auto* group : {&impl_->liver, &impl_->vessels, &impl_->lesions})
    for (const auto& bound : *group)
      move_vertices(*bound->shape, bound->surface->binding.apply(impl_->model->model->mesh, nodes_in_camera));
  return {impl_->pass(impl_->liver), impl_->pass(impl_->vessels), impl_->pass(impl_->lesions)};
}

}  // namespace glisson::scene
