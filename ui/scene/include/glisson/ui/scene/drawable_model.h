// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "glisson/patient/patient_model.h"
#include "glisson/ui/scene/sided_triangles.h"

namespace glisson::scene {

/// A vertex outside the model's mesh, where the mechanics says nothing. It is drawn as if the closest surface
/// of the mesh took it along, less with distance.
struct OutsideVertex {
  int vertex = -1;
  int triangle = -1;  ///< of PatientModel::surface
  Eigen::Vector3d weights = Eigen::Vector3d::Zero();
  double follows = 0.0;  ///< share of the surface's displacement: 1 within 3 mm, 0 far away
};

/// A structure's surface, light enough to be drawn live, bound to the model's mesh.
struct DrawableSurface {
  Label structure = 0;
  TriangleMesh mesh;  ///< CT frame, at rest
  Binding binding;    ///< empty when the model has no tetrahedra
  /// Triangles within 3 mm of the model's mesh: only there it is known how they move.
  SidedTriangles inside;
  std::vector<OutsideVertex> outside;  ///< of neighbours and of vessels that run on; not of the liver
};

/// Metres; a surgeon seals thinner vessels without looking for them.
inline constexpr double kThin = 1.5e-3;

/// Everything of a model that is drawn. Takes seconds to make for fine surfaces: make it beside the window's
/// thread, once a model, and share it.
struct DrawableModel {
  std::shared_ptr<const PatientModel> model;
  std::vector<DrawableSurface> surfaces;  ///< liver first, then vessels, lesions and neighbours
  /// Of vessels whose centrelines are known, beside their surfaces: smooth tubes of the same width, without
  /// thin distal branches (under kThin in radius, with all that follows behind). Bound like the surfaces.
  std::vector<DrawableSurface> tubes;
};
/// @param triangles at most about so many a structure. @pre model is not null.
std::shared_ptr<const DrawableModel> make_drawable(std::shared_ptr<const PatientModel> model,
                                                   int triangles = 12000);

/// What is drawn over the laparoscope's picture, a surface a structure: tubes stand for their structures'
/// surfaces, unless thin branches are wanted, too.
std::vector<const DrawableSurface*> drawn_surfaces(const DrawableModel& model, bool thin_branches);

/// Where a surface's vertices are when a load has moved the model's nodes to `at` (CT frame). Vertices
/// outside the mesh follow as OutsideVertex says; the gallbladder moves rigidly with its bed.
/// @pre the surface is bound, `at` has one row a node.
Points loaded_vertices(const PatientModel& model, const DrawableSurface& surface, const Points& at);

}  // namespace glisson::scene
