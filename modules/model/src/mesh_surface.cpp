// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "fit_to_surface.h"
#include "glisson/core/error.h"
#include "glisson/geometry/topology.h"
#include "glisson/model/build.h"
#include "mesh_to_size.h"
#include "surface_field.h"

namespace glisson::model {

void MeshOptions::validate() const {
  if (target_vertices < 20 || target_vertices > 200000)
    throw InputError("mesh options", "target_vertices",
                     "is " + std::to_string(target_vertices) + ", out of range",
                     "Ask for 20 to 200000 vertices");
  if (edge_mm != 0.0 && !(edge_mm >= 1.0 && edge_mm <= 100.0))
    throw InputError("mesh options", "edge_mm", "is " + std::to_string(edge_mm) + ", out of range",
                     "Give an edge length of 1 to 100 mm");
  if (!(vessel_refinement >= 0.2 && vessel_refinement <= 1.0))
    throw InputError("mesh options", "vessel_refinement",
                     "is " + std::to_string(vessel_refinement) + ", out of range",
                     "Give a ratio of 0.2 to 1");
  if (!(lesion_refinement >= 0.1 && lesion_refinement <= 10.0))
    throw InputError("mesh options", "lesion_refinement",
                     "is " + std::to_string(lesion_refinement) + ", out of range",
                     "Give a ratio of 0.1 to 10");
}

Cancellable<TetMesh> mesh_surface(const TriangleMesh& surface, const MeshOptions& options,
                                  const RunContext& context) {
  options.validate();
  const TriangleMesh closed = largest_closed_piece(surface, "surface");
  context.progress(0.0, "model.mesh.field");
  MesherInput input;
  input.body = field_of_surface(closed, body_spacing_mm(closed, options));
  std::vector<std::string> notes;
  auto mesh = mesh_to_size(input, options, notes, context.part(0.1, 1.0));
  if (!mesh || !fit_to_surface(*mesh, {&closed, volume(closed), {}}, kLeastDihedral, context)) return {};
  return mesh;
}

}  // namespace glisson::model
