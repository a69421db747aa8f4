// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/guidance/place_picker.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "glisson/core/error.h"
#include "glisson/geometry/closest_point_tree.h"
#include "pixel_scale.h"

namespace glisson::guidance {
namespace {

constexpr double kReach = 0.015;   ///< of the picture's width
constexpr double kShallow = 3e-3;  ///< metres from a vessel's wall to the surface
/// Metres of the ray: a mesh of some hundred nodes bridges notches and cuts margins off by a centimetre.
constexpr double kHiddenBehind = 15e-3;

using Segments = std::vector<std::array<int, 2>>;

/// The model as one view shows it.
class Shown {
 public:
  Shown(const PatientModel& model, const Points& nodes, const StereoRig& rig, StereoView view)
      : model_(model), nodes_(nodes) {
    camera_ = view == StereoView::left ? rig.left : rig.right;
    if (view == StereoView::right)
      nodes_ = (nodes * rig.right_from_left.rotation.transpose()).rowwise() +
               rig.right_from_left.translation.transpose();
    surface_ = model.surface.mesh;
    for (int i = 0; i < surface_.vertex_count(); ++i)
      surface_.vertices.row(i) = nodes_.row(model.surface.node_of_vertex[static_cast<std::size_t>(i)]);
    tree_ = ClosestPointTree(surface_);
  }

  double reach() const { return kReach * camera_.width; }

  std::optional<PickedPlace> on_surface(const Eigen::Vector2d& pixel) const {
    const auto ray = camera_.mapped_ray(pixel);
    if (!ray) return std::nullopt;
    const ClosestPoint hit = tree_.first_hit(Eigen::Vector3d::Zero(), *ray);
    if (hit.triangle < 0) return std::nullopt;
    PickedPlace place;
    place.pixel = pixel;
    for (int k = 0; k < 3; ++k) {
      const int vertex = surface_.triangles(hit.triangle, k);
      place.place_in_ct +=
          hit.barycentric[k] *
          model_.mesh.vertex(model_.surface.node_of_vertex[static_cast<std::size_t>(vertex)]);
    }
    return place;
  }

  /// The nearest place of lines between points of the CT.
  std::optional<PickedPlace> on_lines(const Points& in_ct, const Segments& segments, CorrectedFeature feature,
                                      const Eigen::Vector2d& pixel, double reach) const {
    if (in_ct.rows() == 0) return std::nullopt;
    const Points now = bind_points(model_.mesh, in_ct, false).apply(model_.mesh, nodes_);
    std::optional<PickedPlace> best;
    for (const auto& [a, b] : segments) {
      if (!camera_.maps(now.row(a).transpose()) || !camera_.maps(now.row(b).transpose())) continue;
      const Eigen::Vector2d p = camera_.project(now.row(a).transpose()),
                            way = camera_.project(now.row(b).transpose()) - p;
      const double length2 = way.squaredNorm();
      const double t = length2 > 0.0 ? std::clamp((pixel - p).dot(way) / length2, 0.0, 1.0) : 0.0;
      const Eigen::Vector2d at = p + t * way;
      const double away = (at - pixel).norm();
      if (away > reach) continue;
      const Eigen::Vector3d there = ((1.0 - t) * now.row(a) + t * now.row(b)).transpose();
      if (is_hidden(there)) continue;
      reach = away;
      best = PickedPlace{feature, ((1.0 - t) * in_ct.row(a) + t * in_ct.row(b)).transpose(), at};
    }
    return best;
  }

 private:
  bool is_hidden(const Eigen::Vector3d& p) const {
    const double most = 1.0 - kHiddenBehind / p.norm();
    return tree_.first_hit(Eigen::Vector3d::Zero(), p, 0.0, most).triangle >= 0;
  }

  const PatientModel& model_;
  Camera camera_;
  Points nodes_;
  TriangleMesh surface_;
  ClosestPointTree tree_;
};

Segments chain(Eigen::Index count) {
  Segments segments;
  if (count == 1) segments.push_back({0, 0});
  for (int i = 1; i < count; ++i) segments.push_back({i - 1, i});
  return segments;
}

/// The pieces of a tree that run next to the surface.
Segments shallow(const PatientModel& model, const VesselTree& tree) {
  const ClosestPointTree surface(model.surface.mesh);
  std::vector<char> is_shallow;
  for (Eigen::Index i = 0; i < tree.nodes.rows(); ++i) {
    const double wall = kShallow + tree.radii[static_cast<std::size_t>(i)];
    is_shallow.push_back(surface.closest(tree.nodes.row(i).transpose(), wall).triangle >= 0);
  }
  Segments segments;
  for (const auto& [a, b] : tree.beams)
    if (is_shallow[static_cast<std::size_t>(a)] != 0 && is_shallow[static_cast<std::size_t>(b)] != 0)
      segments.push_back({a, b});
  return segments;
}

/// What comes first of what lies there.
std::optional<PickedPlace> find_place(const PatientModel& model, const Shown& shown,
                                      const Eigen::Vector2d& pixel, double reach) {
  const Landmarks& known = model.landmarks;
  if (auto notch = shown.on_lines(known.umbilical_notch, chain(known.umbilical_notch.rows()),
                                  CorrectedFeature::notch, pixel, reach))
    return notch;
  if (auto margin = shown.on_lines(known.anterior_margin, chain(known.anterior_margin.rows()),
                                   CorrectedFeature::margin, pixel, reach))
    return margin;
  for (const VesselTree& tree : model.vessels)
    if (auto vessel =
            shown.on_lines(tree.nodes, shallow(model, tree), CorrectedFeature::vessel, pixel, reach))
      return vessel;
  return shown.on_surface(pixel);
}

}  // namespace

std::optional<PickedPlace> pick_place(const PatientModel& model, const Points& nodes_in_camera,
                                      const StereoRig& rig, StereoView view, const Eigen::Vector2d& pixel,
                                      double reach_px) {
  require(nodes_in_camera.rows() == model.mesh.vertex_count(), "a place is picked on this model's nodes");
  if (!pixel.allFinite()) return std::nullopt;
  const Shown shown(model, nodes_in_camera, rig, view);
  auto place = find_place(model, shown, pixel, reach_px < 0.0 ? shown.reach() : reach_px);
  if (place) place->sigma_px *= pixel_scale((view == StereoView::left ? rig.left : rig.right).width);
  return place;
}

std::optional<Eigen::Vector2d> pixel_of(const PatientModel& model, const Points& nodes_in_camera,
                                        const StereoRig& rig, StereoView view,
                                        const Eigen::Vector3d& place_in_ct) {
  const Points place =
      bind_points(model.mesh, place_in_ct.transpose(), false).apply(model.mesh, nodes_in_camera);
  Eigen::Vector3d p = place.row(0).transpose();
  if (view == StereoView::right) p = rig.right_from_left.rotation * p + rig.right_from_left.translation;
  const Camera& camera = view == StereoView::left ? rig.left : rig.right;
  if (!camera.maps(p)) return std::nullopt;
  return camera.project(p);
}

}  // namespace glisson::guidance
