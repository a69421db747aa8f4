// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/core/run_context.h"
#include "glisson/geometry/closest_point_tree.h"
#include "glisson/geometry/mesh.h"
#include "surface_samples.h"

namespace glisson::atlas {

/// The last millimetres: vertices go to the closest points of a surface, and the surface's samples pull what
/// lies closest to them, while neighbours keep their shape (as rigid as possible, Sorkine and Alexa 2007),
/// less and less. What the mesh has become is its rest shape of the next, softer level.
/// @param mesh near the surface. @param samples of the surface.
/// @return the vertices. Empty: cancelled.
Cancellable<Points> fit_closest(const TriangleMesh& mesh, const TriangleMesh& surface,
                                const ClosestPointTree& tree, const SurfaceSamples& samples,
                                const RunContext& context);

}  // namespace glisson::atlas
