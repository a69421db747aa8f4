// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/guidance/tool_meter.h"

#include <utility>

#include "glisson/core/error.h"
#include "glisson/geometry/closest_point_tree.h"

namespace glisson::guidance {
namespace {

struct Carried {
  Label structure;
  Binding binding;
  ClosestPointTree tree;

  explicit Carried(CarriedSurface surface)
      : structure(surface.structure), binding(std::move(surface.binding)), tree(surface.mesh) {}
};

}  // namespace

struct ToolMeter::Impl {
  TetMesh mesh;
  Carried organ;
  std::vector<Carried> lesions;
};

ToolMeter::ToolMeter(const PatientModel& model, CarriedSurface organ, std::vector<CarriedSurface> lesions) {
  require(organ.mesh.triangle_count() > 0, "an organ has a surface");
  impl_ = std::unique_ptr<Impl>(new Impl{model.mesh, Carried(std::move(organ)), {}});
  for (CarriedSurface& lesion : lesions)
    if (lesion.mesh.triangle_count() > 0) impl_->lesions.emplace_back(std::move(lesion));
}
ToolMeter::~ToolMeter() = default;

void ToolMeter::move(const Points& nodes_in_camera) {
  require(nodes_in_camera.rows() == impl_->mesh.vertex_count(), "the nodes are those of the model");
  impl_->organ.tree.refit(impl_->organ.binding.apply(impl_->mesh, nodes_in_camera));
  for (Carried& lesion : impl_->lesions)
    lesion.tree.refit(lesion.binding.apply(impl_->mesh, nodes_in_camera));
}

ToolMeasures ToolMeter::measure(const Eigen::Vector3d& tip_in_camera, Label lesion) const {
  ToolMeasures measures;
  if (!tip_in_camera.allFinite()) return measures;
  const ClosestPoint nearest = impl_->organ.tree.closest(tip_in_camera);
  measures.to_surface = nearest.distance;
  if (nearest.distance <= kTouching) measures.touched = SurfacePlace{nearest.triangle, nearest.barycentric};
  for (const Carried& one : impl_->lesions)
    if (one.structure == lesion) measures.to_lesion = one.tree.closest(tip_in_camera).distance;
  return measures;
}

}  // namespace glisson::guidance
