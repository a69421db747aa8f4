// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "glisson/patient/patient_model.h"

namespace glisson::scene {

/// A structure's surface, light enough to be drawn live, bound to the model's mesh.
struct DrawableSurface {
  Label structure = 0;
  TriangleMesh mesh;  ///< CT frame, at rest
  Binding binding;    ///< empty when the model has no tetrahedra
  /// Triangles within 3 mm of the model's mesh: only there it is known how they move.
  Triangles inside;
};

/// Everything of a model that is drawn. Takes seconds to make for fine surfaces: make it beside the window's
/// thread, once a model, and share it.
struct DrawableModel {
  std::shared_ptr<const PatientModel> model;
  std::vector<DrawableSurface> surfaces;  ///< liver first, then vessels, lesions and neighbours
};
/// @param triangles at most about so many a structure. @pre model is not null.
std::shared_ptr<const DrawableModel> make_drawable(std::shared_ptr<const PatientModel> model,
                                                   int triangles = 12000);

}  // namespace glisson::scene
