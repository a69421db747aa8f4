// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/scene/drawable_model.h"

#include <algorithm>
#include <utility>

#include "glisson/core/error.h"
#include "glisson/geometry/closest_point_tree.h"
#include "glisson/geometry/rigid.h"
#include "glisson/patient/label_map.h"
#include "glisson/ui/scene/model_surfaces.h"
#include "vessel_tubes.h"

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

/// Says how a surface moves with the model's mesh. @pre there is one.
void bind(DrawableSurface& surface, const PatientModel& model, const ClosestPointTree& skin) {
  surface.binding = bind_points(model.mesh, surface.mesh.vertices, false);
  // The liver itself is drawn whole: its fine surface is what the mesh was made from.
  const bool is_liver = surface.structure == structure::kParenchyma;
  if (!is_liver) surface.outside = outside_vertices(surface, skin);
  surface.inside = sort_by_sides(surface.mesh, is_liver ? surface.mesh.triangles : triangles_inside(surface));
}

std::vector<const VesselTree*> trees_of(const PatientModel& model, Label structure) {
  std::vector<const VesselTree*> trees;
  for (const VesselTree& tree : model.vessels)
    if (tree.structure == structure && !tree.beams.empty() &&
        tree.radii.size() == static_cast<std::size_t>(tree.nodes.rows()))
      trees.push_back(&tree);
  return trees;
}

/// What of vessels lies in the model's mesh, or so near that it is known how it moves.
std::vector<VesselCourse> known_parts(const std::vector<VesselCourse>& courses, const PatientModel& model,
                                      const ClosestPointTree& skin) {
  Eigen::Index count = 0;
  for (const VesselCourse& course : courses) count += static_cast<Eigen::Index>(course.size());
  Points centres(count, 3);
  count = 0;
  for (const VesselCourse& course : courses)
    for (const Eigen::Vector4d& place : course) centres.row(count++) = place.head<3>().transpose();
  std::vector<bool> is_known(static_cast<std::size_t>(count), true);
  for (const int i : bind_points(model.mesh, centres).outside)
    is_known[static_cast<std::size_t>(i)] =
        skin.closest(centres.row(i).transpose()).distance <= kOutsideTolerance;
  std::vector<VesselCourse> parts;
  std::size_t place = 0;
  for (const VesselCourse& course : courses) {
    VesselCourse part;
    const auto end = [&] {
      if (part.size() > 1) parts.push_back(part);
      part.clear();
    };
    for (const Eigen::Vector4d& ring : course)
      if (is_known[place++])
        part.push_back(ring);
      else
        end();
    end();
  }
  return parts;
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
    if (has_mesh) bind(surface, *model, skin);
    drawable->surfaces.push_back(std::move(surface));
    const std::vector<const VesselTree*> trees = trees_of(*model, label);
    if (trees.empty() || !has_mesh) continue;
    DrawableSurface tubes;
    tubes.structure = label;
    tubes.mesh = tubes_around(known_parts(vessel_courses(trees, triangles), *model, skin));
    tubes.binding = bind_points(model->mesh, tubes.mesh.vertices, false);
    tubes.inside = sort_by_sides(tubes.mesh, tubes.mesh.triangles);
    drawable->tubes.push_back(std::move(tubes));
  }
  drawable->model = std::move(model);
  return drawable;
}

std::vector<const DrawableSurface*> drawn_surfaces(const DrawableModel& model, bool thin_branches) {
  std::vector<const DrawableSurface*> drawn;
  for (const DrawableSurface& surface : model.surfaces) {
    const auto tubes = std::find_if(model.tubes.begin(), model.tubes.end(), [&](const DrawableSurface& one) {
      return one.structure == surface.structure;
    });
    drawn.push_back(thin_branches || tubes == model.tubes.end() ? &surface : &*tubes);
  }
  return drawn;
}

}  // namespace glisson::scene
