// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/guidance/tool_meter.h"

#include <utility>

#include "glisson/core/error.h"
#include "glisson/geometry/closest_point_tree.h"

namespace glisson::guidance {
namespace {

/// Whether a ray from there crosses a closed surface an odd number of times.
bool leaves_once_more(const ClosestPointTree& tree, const Eigen::Vector3d& from,
                      const Eigen::Vector3d& direction) {
  constexpr double kBeyond = 1e-7;  // metres behind a crossing the next one is looked for
  bool odd = false;
  for (double along = 0.0;; odd = !odd) {
    const ClosestPoint hit = tree.first_hit(from, direction, along);
    if (hit.triangle < 0) return odd;
    along = hit.distance + kBeyond;
  }
}

/// By the most of three rays: one may run along an edge. @pre the surface is closed.
bool is_inside(const ClosestPointTree& tree, const Eigen::Vector3d& p) {
  int inside = 0;
  for (const Eigen::Vector3d& way : {Eigen::Vector3d(0.36, 0.48, -0.80), Eigen::Vector3d(-0.61, 0.35, 0.71),
                                     Eigen::Vector3d(0.29, -0.87, 0.40)})
    inside += leaves_once_more(tree, p, way.normalized());
  return inside >= 2;
}

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
  measures.is_inside = is_inside(impl_->organ.tree, tip_in_camera);
  if (nearest.distance <= kTouching) measures.touched = SurfacePlace{nearest.triangle, nearest.barycentric};
  for (const Carried& one : impl_->lesions)
    if (one.structure == lesion) measures.to_lesion = one.tree.closest(tip_in_camera).distance;
  return measures;
}

}  // namespace glisson::guidance
