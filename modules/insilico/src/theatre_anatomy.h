// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/core/run_context.h"
#include "glisson/patient/patient_model.h"

namespace glisson::insilico {

/// The closed outer surface of the patient's liver: the surface named "liver" (or of the parenchyma), its
/// largest component; else the boundary of the mesh. Outward. @throws InputError none, or not closed.
TriangleMesh liver_of(const PatientModel& patient);

/// What is inside, finer than the model that is registered: the truth moves by it. @param closed as
/// liver_of(). @param vertices about so many.
Cancellable<TetMesh> truth_mesh(const TriangleMesh& closed, int vertices, const RunContext& context);

/// Fine enough to be drawn without facets: triangles split in four, new vertices on the surface that the
/// vertex normals suggest (Phong tessellation, Boubekeur and Alexa 2008), until there are `triangles`.
TriangleMesh refine_for_drawing(TriangleMesh surface, int triangles);

/// Vertex normals for shading, averaged over `passes` rings of neighbours.
Points shading_normals(const TriangleMesh& surface, const std::vector<std::vector<int>>& neighbours,
                       int passes);

/// The patient's landmarks; a missing margin is detected, a missing notch placed by rule: where the margin
/// runs in deepest towards the head between points 30 mm along it on either side.
Landmarks complete_landmarks(const Landmarks& known, const TriangleMesh& liver);

/// Labels every tetrahedron whose centre lies in a lesion's surface.
void label_lesions(TetMesh& mesh, const std::vector<NamedSurface>& surfaces);

}  // namespace glisson::insilico
