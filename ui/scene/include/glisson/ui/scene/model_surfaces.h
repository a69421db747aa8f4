// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glisson/patient/patient_model.h"

namespace glisson::scene {

/// At most about `triangles` triangles of the same shape (quadric decimation); smaller meshes come back as
/// they are.
TriangleMesh simplified(const TriangleMesh& mesh, int triangles);
/// The tree as tubes of its outer radius, `sides` flat sides around. Empty for a tree without beams.
TriangleMesh tube_mesh(const VesselTree& tree, int sides = 10);

/// Where the model's structure lies, from the best source there is: its fine surface, else the tubes of its
/// tree (vessels), else the boundary of its tetrahedra (lesions, liver). Empty when the model has none.
TriangleMesh structure_surface(const PatientModel& model, Label structure);
/// The structures of a model that can be drawn inside the liver: vessels and lesions, ascending.
std::vector<Label> inner_structures(const PatientModel& model);

}  // namespace glisson::scene
