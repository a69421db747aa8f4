// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/scene/drawable_model.h"

#include <limits>
#include <utility>

#include "glisson/core/error.h"
#include "glisson/geometry/closest_point_tree.h"
#include "glisson/geometry/rigid.h"
#include "glisson/patient/label_map.h"
#include "glisson/ui/scene/model_surfaces.h"

namespace glisson::scene {
namespace {

/// Vessels run on outside the liver, where the model says nothing of how they move.
constexpr double kOutsideTolerance = 3e-3;

/// Beyond that, what is attached to the liver goes along with it over about this length, metres.
constexpr double kFade = 15e-3;

std::vector<OutsideVertex> outside_vertices(const DrawableSurface& surface, const ClosestPointTree& skin) {
  std::vector<OutsideVertex> outside;
  for (const int i : surface.binding.outside) {
    const ClosestPoint closest = skin.closest(surface.mesh.vertex(i));
    if (closest.triangle < 0) continue;
    const double beyond = std::max(0.0, closest.distance - kOutsideTolerance) / kFade;
    outside.push_back({i, closest.triangle, closest.barycentric, std::exp(-beyond * beyond)});
  }
  return outside;
}

Triangles triangles_inside(const DrawableSurface& surface) {
  std::vector<bool> far(static_cast<std::size_t>(surface.mesh.vertex_count()), false);
  for (const OutsideVertex& vertex : surface.outside)
    far[static_cast<std::size_t>(vertex.vertex)] = vertex.follows < 1.0;
  Triangles kept(surface.mesh.triangles.rows(), 3);
  Eigen::Index count = 0;
  for (Eigen::Index t = 0; t < surface.mesh.triangles.rows(); ++t) {
    bool near = true;
    for (int k = 0; k < 3; ++k) near = near && !far[static_cast<std::size_t>(surface.mesh.triangles(t, k))];
    if (near) kept.row(count++) = surface.mesh.triangles.row(t);
  }
  return kept.topRows(count);
}

/// Whether each node of a tree is thin, and all that follows behind it.
std::vector<bool> thin_nodes(const VesselTree& tree) {
  std::vector<double> widest = tree.radii;
  // Beams run from the root outwards: from the last to the first, what is behind is known already.
  for (auto beam = tree.beams.rbegin(); beam != tree.beams.rend(); ++beam) {
    double& here = widest[static_cast<std::size_t>((*beam)[0])];
    here = std::max(here, widest[static_cast<std::size_t>((*beam)[1])]);
  }
  std::vector<bool> thin(widest.size());
  for (std::size_t i = 0; i < widest.size(); ++i) thin[i] = widest[i] < kThin;
  return thin;
}

/// A triangle belongs to the node of the trees that is nearest, less the node's radius.
Triangles thick_triangles(const PatientModel& model, const DrawableSurface& surface, const Triangles& of) {
  std::vector<std::pair<const VesselTree*, std::vector<bool>>> trees;
  for (const VesselTree& tree : model.vessels)
    if (tree.structure == surface.structure &&
        tree.radii.size() == static_cast<std::size_t>(tree.nodes.rows()))
      trees.emplace_back(&tree, thin_nodes(tree));
  const auto is_thin = [&](const Eigen::RowVector3d& place) {
    double nearest = std::numeric_limits<double>::infinity();
    bool thin = false;
    for (const auto& [tree, nodes] : trees)
      for (Eigen::Index i = 0; i < tree->nodes.rows(); ++i) {
        const auto node = static_cast<std::size_t>(i);
        const double distance = (tree->nodes.row(i) - place).norm() - tree->radii[node];
        if (distance >= nearest) continue;
        nearest = distance;
        thin = nodes[node];
      }
    return thin;
  };
  Triangles kept(of.rows(), 3);
  Eigen::Index count = 0;
  for (Eigen::Index t = 0; t < of.rows(); ++t) {
    Eigen::RowVector3d middle = Eigen::RowVector3d::Zero();
    for (int k = 0; k < 3; ++k) middle += surface.mesh.vertices.row(of(t, k)) / 3.0;
    if (!is_thin(middle)) kept.row(count++) = of.row(t);
  }
  return kept.topRows(count);
}

/// As a body with those of its vertices that are attached.
Points with_its_bed(const DrawableSurface& surface, const Points& moved) {
  constexpr Eigen::Index kFewest = 10;  // that tell how a body turns
  std::vector<bool> attached(static_cast<std::size_t>(surface.mesh.vertex_count()), true);
  for (const OutsideVertex& outside : surface.outside)
    attached[static_cast<std::size_t>(outside.vertex)] = outside.follows == 1.0;
  Points from(surface.mesh.vertex_count(), 3), to(surface.mesh.vertex_count(), 3);
  Eigen::Index count = 0;
  for (int i = 0; i < surface.mesh.vertex_count(); ++i) {
    if (!attached[static_cast<std::size_t>(i)]) continue;
    from.row(count) = surface.mesh.vertices.row(i);
    to.row(count++) = moved.row(i);
  }
  if (count < kFewest) return moved;
  return fit_rigid<CtFrame, CtFrame>(from.topRows(count), to.topRows(count)).apply(surface.mesh.vertices);
}

}  // namespace

Points loaded_vertices(const PatientModel& model, const DrawableSurface& surface, const Points& at) {
  require(at.rows() == model.mesh.vertex_count(), "a load moves the nodes of its model");
  Points vertices = surface.binding.apply(model.mesh, at);
  for (const OutsideVertex& outside : surface.outside) {
    Eigen::RowVector3d displacement = Eigen::RowVector3d::Zero();
    for (int k = 0; k < 3; ++k) {
      const int vertex = model.surface.mesh.triangles(outside.triangle, k);
      const int node = model.surface.node_of_vertex[static_cast<std::size_t>(vertex)];
      displacement += outside.weights[k] * (at.row(node) - model.mesh.vertices.row(node));
    }
    vertices.row(outside.vertex) = surface.mesh.vertices.row(outside.vertex) + outside.follows * displacement;
  }
  return surface.structure == structure::kGallbladder ? with_its_bed(surface, vertices) : vertices;
}

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
    Triangles inside;  // none without a mesh
    if (has_mesh) {
      surface.binding = bind_points(model->mesh, surface.mesh.vertices, false);
      // The liver itself is drawn whole: its fine surface is what the mesh was made from.
      if (label != structure::kParenchyma) surface.outside = outside_vertices(surface, skin);
      inside = label == structure::kParenchyma ? surface.mesh.triangles : triangles_inside(surface);
    }
    surface.inside = sort_by_sides(surface.mesh, inside);
    surface.thick = sort_by_sides(surface.mesh, thick_triangles(*model, surface, inside));
    drawable->surfaces.push_back(std::move(surface));
  }
  drawable->model = std::move(model);
  return drawable;
}

}  // namespace glisson::scene
