// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/scene/seen_point.h"

#include <Eigen/Geometry>

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkMapper.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <limits>

namespace glisson::scene {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

/// From the near plane (share 0) to the far one (1).
struct Ray {
  Eigen::Vector3d from, along;
};

Ray ray_of(vtkRenderer& renderer, double x, double y, double aspect) {
  vtkNew<vtkMatrix4x4> scene_from_clip;
  scene_from_clip->DeepCopy(
      renderer.GetActiveCamera()->GetCompositeProjectionTransformMatrix(aspect, -1.0, 1.0));
  scene_from_clip->Invert();
  const auto at = [&](double depth) -> Eigen::Vector3d {
    const double clip[4] = {2.0 * x - 1.0, 1.0 - 2.0 * y, depth, 1.0};
    double p[4];
    scene_from_clip->MultiplyPoint(clip, p);
    return Eigen::Vector3d(p[0], p[1], p[2]) / p[3];
  };
  const Eigen::Vector3d from = at(-1.0);
  return {from, at(1.0) - from};
}

/// Möller and Trumbore (1997). @return the ray's share; kNone: it passes.
double meets(const Ray& ray, const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const Eigen::Vector3d ab = b - a, ac = c - a, normal = ray.along.cross(ac);
  const double determinant = ab.dot(normal);
  if (determinant == 0.0) return kNone;
  const Eigen::Vector3d away = ray.from - a;
  const double u = away.dot(normal) / determinant;
  const Eigen::Vector3d beside = away.cross(ab);
  const double v = ray.along.dot(beside) / determinant;
  if (u < 0.0 || v < 0.0 || u + v > 1.0) return kNone;
  const double share = ac.dot(beside) / determinant;
  return share >= 0.0 && share <= 1.0 ? share : kNone;
}

bool meets_box(const Ray& ray, const double* bounds) {
  const Eigen::Vector3d low(bounds[0], bounds[2], bounds[4]), high(bounds[1], bounds[3], bounds[5]);
  const Eigen::Array3d to_low = (low - ray.from).array() / ray.along.array(),
                       to_high = (high - ray.from).array() / ray.along.array();
  return to_low.min(to_high).maxCoeff() <= to_low.max(to_high).minCoeff();
}

double first_hit(const Ray& ray, vtkActor& actor) {
  auto* surface = vtkPolyData::SafeDownCast(actor.GetMapper()->GetInput());
  if (surface == nullptr || surface->GetNumberOfPoints() == 0 || !meets_box(ray, surface->GetBounds()))
    return kNone;
  double nearest = kNone;
  const auto corner = [surface](vtkIdType id) -> Eigen::Vector3d {
    double p[3];
    surface->GetPoint(id, p);
    return {p[0], p[1], p[2]};
  };
  vtkCellArray& triangles = *surface->GetPolys();
  vtkIdType size = 0;
  const vtkIdType* ids = nullptr;
  for (triangles.InitTraversal(); triangles.GetNextCell(size, ids) != 0;)
    if (size == 3) nearest = std::min(nearest, meets(ray, corner(ids[0]), corner(ids[1]), corner(ids[2])));
  return nearest;
}

}  // namespace

std::optional<Eigen::Vector3d> seen_point(vtkRenderer& renderer, const std::vector<vtkActor*>& actors,
                                          double x, double y, double aspect) {
  const Ray ray = ray_of(renderer, x, y, aspect);
  double solid = kNone, skin = kNone, slice = kNone;
  for (vtkActor* actor : actors) {
    if (actor->GetVisibility() == 0 || actor->GetProperty()->GetOpacity() <= 0.0) continue;
    double& nearest = actor->GetTexture() != nullptr             ? slice
                      : actor->GetProperty()->GetOpacity() < 1.0 ? skin
                                                                 : solid;
    nearest = std::min(nearest, first_hit(ray, *actor));
  }
  const double pointed = solid < slice ? solid : std::min(skin, slice);
  if (pointed == kNone) return std::nullopt;
  return ray.from + pointed * ray.along;
}

}  // namespace glisson::scene
