// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/insilico/ray_caster.h"
#include "glisson/insilico/theatre.h"

namespace glisson::insilico {

/// Grows a connected patch over the triangles that face the camera and that nothing hides, from the one
/// nearest to `start`, by distance along the surface; where they do not suffice, over those that face it,
/// then over any. Samples it. All in the left camera's frame.
Patch sample_patch(const TriangleMesh& surface, const RayCaster& caster, const Eigen::Vector3d& start,
                   const Points& margin, const Points& notch, const PatchOptions& options);

/// The same over what any of several cameras sees, of the first first; then what each of them sees of it. All
/// in the first camera's frame. What none sees is left out: the patch may be smaller than is wanted.
/// @pre the first sees something. @param eyes the cameras, the first of them in the origin. @return a cloud
/// each, empty of those that add nothing.
std::vector<Patch> sample_looks(const TriangleMesh& surface, const RayCaster& caster,
                                const Eigen::Vector3d& start, const Points& margin, const Points& notch,
                                const PatchOptions& options, const std::vector<Eigen::Vector3d>& eyes);

}  // namespace glisson::insilico
