// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "glisson/core/error.h"
#include "glisson/fem/loads_io.h"

namespace glisson::fem {
namespace {

bool contains(const LoadRegion& region, const Eigen::Vector3d& p) {
  if (region.centre && (p - *region.centre).norm() > region.radius) return false;
  if (region.low && ((p - *region.low).minCoeff() < 0.0 || (*region.high - p).minCoeff() < 0.0)) return false;
  return true;
}

std::vector<int> triangles_of(const LoadRegion& region, const TriangleMesh& surface) {
  const Points normals = triangle_normals(surface);
  std::vector<int> result;
  for (int t = 0; t < surface.triangle_count(); ++t) {
    const Eigen::Vector3d centre =
        (surface.vertex(surface.triangles(t, 0)) + surface.vertex(surface.triangles(t, 1)) +
         surface.vertex(surface.triangles(t, 2))) /
        3.0;
    if (region.normal && normals.row(t).dot(region.normal->transpose()) < std::cos(region.angle)) continue;
    if (contains(region, centre)) result.push_back(t);
  }
  return result;
}

void check_node(int node, const CompositeModel& model, const std::string& field) {
  if (node < 0 || node >= model.node_count())
    throw InputError("load", field, "names node " + std::to_string(node),
                     "The mesh has nodes 0 to " + std::to_string(model.node_count() - 1));
}

[[noreturn]] void fail_empty(const std::string& field) {
  throw InputError("load", field, "holds nothing of the mesh",
                   "Move or widen the region (millimetres, in the mesh's frame)");
}

}  // namespace

std::vector<std::pair<AppliedLoad::Anchor, double>> AppliedLoad::places(const LoadPlace& place,
                                                                        const CompositeModel& model,
                                                                        const std::string& field) const {
  std::vector<std::pair<Anchor, double>> result;
  if (place.node) {
    check_node(*place.node, model, field);
    Anchor anchor;
    anchor.nodes[0] = *place.node;
    anchor.weights[0] = 1.0;
    result.emplace_back(anchor, 1.0);
  } else if (place.point) {
    Points point(1, 3);
    point.row(0) = place.point->transpose();
    const Binding binding = bind_points(model.mesh(), point, true);
    Anchor anchor;
    for (int k = 0; k < 4; ++k) {
      anchor.nodes[static_cast<std::size_t>(k)] = model.mesh().tetrahedra(binding.tetrahedron[0], k);
      anchor.weights[static_cast<std::size_t>(k)] = binding.weights(0, k);
    }
    result.emplace_back(anchor, 1.0);
  } else {
    const BoundarySurface& surface = model.surface();
    const Eigen::VectorXd areas = vertex_areas(surface.mesh);
    double total = 0.0;
    for (int v = 0; v < surface.mesh.vertex_count(); ++v) {
      if (!contains(*place.region, surface.mesh.vertex(v))) continue;
      Anchor anchor;
      anchor.nodes[0] = surface.node_of_vertex[static_cast<std::size_t>(v)];
      anchor.weights[0] = 1.0;
      result.emplace_back(anchor, areas[v]);
      total += areas[v];
    }
    if (result.empty()) fail_empty(field);
    for (auto& [anchor, share] : result) share /= total;
  }
  return result;
}

AppliedLoad::AppliedLoad(const LoadCase& load, const CompositeModel& model) : ramp_(load.ramp) {
  base_.gravity_change = load.gravity_change;
  base_.pressure = load.pressure;
  // Named twice a triangle bears its pressure once, as a node that is fixed twice.
  std::set<int> named;
  for (const int t : load.pressure_triangles)
    if (named.insert(t).second) base_.pressure_triangles.push_back(t);
  for (const int t : load.pressure_triangles)
    if (t < 0 || t >= model.surface().mesh.triangle_count())
      throw InputError(
          "load", "pressure.triangles", "names triangle " + std::to_string(t),
          "The surface has triangles 0 to " + std::to_string(model.surface().mesh.triangle_count() - 1));
  if (load.pressure_region) {
    std::vector<int> chosen = triangles_of(*load.pressure_region, model.surface().mesh);
    if (!load.pressure_triangles.empty())
      std::erase_if(chosen, [&](int t) {
        return std::find(load.pressure_triangles.begin(), load.pressure_triangles.end(), t) ==
               load.pressure_triangles.end();
      });
    if (chosen.empty()) fail_empty("pressure.region");
    base_.pressure_triangles = std::move(chosen);
  }
  const Points& rest = model.mesh().vertices;
  for (std::size_t i = 0; i < load.springs.size(); ++i) {
    const LoadSpring& spring = load.springs[i];
    for (auto& [anchor, share] : places(spring.place, model, "springs[" + std::to_string(i) + "]")) {
      anchor.stiffness = share * spring.stiffness;
      for (std::size_t k = 0; k < 4; ++k)
        if (anchor.nodes[k] >= 0) anchor.rest += anchor.weights[k] * rest.row(anchor.nodes[k]).transpose();
      anchor.target = spring.target.value_or(anchor.rest);
      anchors_.push_back(anchor);
    }
  }
  for (std::size_t i = 0; i < load.forces.size(); ++i)
    for (auto& [anchor, share] : places(load.forces[i].place, model, "forces[" + std::to_string(i) + "]")) {
      anchor.force = share * load.forces[i].force;
      anchors_.push_back(anchor);
    }
  hold(load, model);
}

void AppliedLoad::hold(const LoadCase& load, const CompositeModel& model) {
  const Points& rest = model.mesh().vertices;
  const auto nodes_in = [&](const std::vector<int>& named, const std::optional<LoadRegion>& region,
                            const std::string& field) {
    for (const int node : named) check_node(node, model, field + ".nodes");
    std::vector<int> nodes = named;
    if (region) {
      for (int node = 0; node < model.node_count(); ++node)
        if (contains(*region, rest.row(node).transpose())) nodes.push_back(node);
      if (nodes.size() == named.size()) fail_empty(field + ".region");
    }
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
  };
  fixed_nodes_ = nodes_in(load.fixed_nodes, load.fixed_region, "fixed");
  for (std::size_t k = 0; k < load.moved.size(); ++k) {
    const LoadMove& move = load.moved[k];
    const std::string field = "moved[" + std::to_string(k) + "]";
    for (const int node : nodes_in(move.nodes, move.region, field)) {
      const auto at = std::lower_bound(fixed_nodes_.begin(), fixed_nodes_.end(), node);
      if (at != fixed_nodes_.end() && *at == node)
        throw InputError("load", field, "holds node " + std::to_string(node) + ", which is held already",
                         "Keep fixed and moved nodes apart");
      fixed_nodes_.insert(at, node);
      moved_.push_back({node, rest.row(node).transpose(), move.by});
    }
  }
}

Points AppliedLoad::start(const CompositeModel& model) const {
  Points x = model.mesh().vertices;
  for (const Moved& moved : moved_) x.row(moved.node) += moved.by.transpose();
  return x;
}

bool AppliedLoad::holds() const {
  return !fixed_nodes_.empty() ||
         std::any_of(anchors_.begin(), anchors_.end(), [](const Anchor& a) { return a.stiffness > 0.0; });
}

Loads AppliedLoad::at(const Points& x) const { return scaled(x, 1.0); }

Loads AppliedLoad::at(const Points& x, double time) const {
  return scaled(x, ramp_ > 0.0 ? std::clamp(time / ramp_, 0.0, 1.0) : 1.0);
}

Loads AppliedLoad::scaled(const Points& x, double fraction) const {
  Loads loads = base_;
  loads.gravity_change *= fraction;
  loads.pressure *= fraction;
  loads.attached.reserve(anchors_.size());
  for (const Anchor& anchor : anchors_) {
    AttachedLoad load;
    load.nodes = anchor.nodes;
    load.weights = anchor.weights;
    load.force = fraction * anchor.force;
    if (anchor.stiffness > 0.0) {
      Eigen::Vector3d p = Eigen::Vector3d::Zero();
      for (std::size_t k = 0; k < 4; ++k)
        if (anchor.nodes[k] >= 0) p += anchor.weights[k] * x.row(anchor.nodes[k]).transpose();
      // It holds from the start; what grows is how far it pulls.
      load.force += anchor.stiffness * (anchor.rest + fraction * (anchor.target - anchor.rest) - p);
      load.tangent = anchor.stiffness * Eigen::Matrix3d::Identity();
    }
    loads.attached.push_back(load);
  }
  for (const Moved& moved : moved_)
    loads.prescribed.push_back({moved.node, moved.rest + fraction * moved.by});
  return loads;
}

}  // namespace glisson::fem
