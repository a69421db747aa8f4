// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/guidance/lesion_meter.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "glisson/core/error.h"
#include "glisson/geometry/closest_point_tree.h"
#include "glisson/patient/label_map.h"

namespace glisson::guidance {
namespace {

struct Moved {
  CarriedSurface surface;
  ClosestPointTree tree;
  Points now;  ///< its vertices, camera frame

  explicit Moved(CarriedSurface given)
      : surface(std::move(given)), tree(surface.mesh), now(surface.mesh.vertices) {}
  void move(const TetMesh& mesh, const Points& nodes) {
    now = surface.binding.apply(mesh, nodes);
    tree.refit(now);
  }
};

/// Nearest hit of a thin bundle of rays: a single one may slip through an edge. Infinite: none.
double first_hit(const ClosestPointTree& tree, const Eigen::Vector3d& direction) {
  constexpr double kApart = 1e-6;
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& [x, y] : {std::pair{0.0, 0.0}, {kApart, 0.7 * kApart}, {-0.6 * kApart, kApart}}) {
    const Eigen::Vector3d ray = direction + direction.z() * Eigen::Vector3d(x, y, 0.0);
    const ClosestPoint hit = tree.first_hit(Eigen::Vector3d::Zero(), ray);
    if (hit.triangle >= 0) nearest = std::min(nearest, hit.distance);
  }
  return nearest;
}

}  // namespace

Figures measure_figures(const LesionMeasures& measures) {
  Figures figures;
  const auto add = [&](const char* what, double metres) {
    if (std::isfinite(metres)) figures[structure_name(measures.lesion) + what] = 1e3 * metres;
  };
  add("_depth_along_sight_mm", measures.along_sight);
  add("_depth_shortest_mm", measures.shortest);
  add("_from_mark_mm", measures.from_place);
  return figures;
}

struct LesionMeter::Impl {
  TetMesh mesh;
  Points nodes;
  Moved organ;
  std::vector<Moved> lesions;

  Impl(const PatientModel& model, CarriedSurface given, std::vector<CarriedSurface> given_lesions)
      : mesh(model.mesh), nodes(model.mesh.vertices), organ(std::move(given)) {
    require(organ.surface.mesh.triangle_count() > 0, "an organ has a surface");
    for (CarriedSurface& lesion : given_lesions)
      if (lesion.mesh.triangle_count() > 0) lesions.emplace_back(std::move(lesion));
  }

  /// The nearest pair of a lesion's vertices and the organ's surface.
  void measure_shortest(const Moved& lesion, LesionMeasures& measures) const {
    constexpr Eigen::Index kStride = 37;  // places all over first: what they find spares most of the others
    double best = std::numeric_limits<double>::infinity();
    for (Eigen::Index first = 0; first < std::min(kStride, lesion.now.rows()); ++first)
      for (Eigen::Index i = first; i < lesion.now.rows(); i += kStride) {
        const Eigen::Vector3d vertex = lesion.now.row(i).transpose();
        const ClosestPoint found = organ.tree.closest(vertex, best);
        if (found.triangle < 0 || found.distance >= best) continue;
        best = measures.shortest = found.distance;
        measures.surface_end = found.point;
        measures.lesion_end = vertex;
      }
  }

  void measure_along_sight(const Moved& lesion, LesionMeasures& measures) const {
    const Eigen::Vector3d centre = lesion.now.colwise().mean().transpose();
    const double entry = first_hit(organ.tree, centre), hit = first_hit(lesion.tree, centre);
    if (std::isfinite(entry) && std::isfinite(hit))
      measures.along_sight = std::max(0.0, hit - entry) * centre.norm();
  }
};

LesionMeter::LesionMeter(const PatientModel& model, CarriedSurface organ, std::vector<CarriedSurface> lesions)
    : impl_(std::make_unique<Impl>(model, std::move(organ), std::move(lesions))) {}
LesionMeter::~LesionMeter() = default;
LesionMeter::LesionMeter(LesionMeter&&) noexcept = default;
LesionMeter& LesionMeter::operator=(LesionMeter&&) noexcept = default;

void LesionMeter::move(const Points& nodes_in_camera) {
  require(nodes_in_camera.rows() == impl_->mesh.vertex_count(), "the nodes are those of the model");
  impl_->nodes = nodes_in_camera;
  impl_->organ.move(impl_->mesh, nodes_in_camera);
}

std::optional<SurfacePlace> LesionMeter::place_on(const Eigen::Vector3d& ray) const {
  const ClosestPoint hit = impl_->organ.tree.first_hit(Eigen::Vector3d::Zero(), ray);
  if (hit.triangle < 0) return {};
  return SurfacePlace{hit.triangle, hit.barycentric};
}

bool LesionMeter::has(const SurfacePlace& place) const {
  return place.triangle >= 0 && place.triangle < impl_->organ.surface.mesh.triangle_count();
}

Eigen::Vector3d LesionMeter::position(const SurfacePlace& place) const {
  require(has(place), "a place is one of this surface");
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  for (int k = 0; k < 3; ++k)
    position += place.weights[k] *
                impl_->organ.now.row(impl_->organ.surface.mesh.triangles(place.triangle, k)).transpose();
  return position;
}

LesionMeasures LesionMeter::measure(Label lesion, const std::optional<SurfacePlace>& place) {
  LesionMeasures measures;
  measures.lesion = lesion;
  const auto found = std::find_if(impl_->lesions.begin(), impl_->lesions.end(),
                                  [lesion](const Moved& one) { return one.surface.structure == lesion; });
  if (found == impl_->lesions.end()) return measures;
  found->move(impl_->mesh, impl_->nodes);
  impl_->measure_shortest(*found, measures);
  impl_->measure_along_sight(*found, measures);
  if (place && has(*place)) measures.from_place = found->tree.closest(position(*place)).distance;
  return measures;
}

}  // namespace glisson::guidance
