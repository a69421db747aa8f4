// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/geometry/mesh.h"

namespace glisson::atlas {

/// Where a vein enters the liver, as its surface tells it (README: "Entrance"). Points of the loop in which
/// the vein crosses the liver's hull, in any order; none: it nowhere comes in.
/// @param liver, vein closed surfaces, one frame, metres
Points entrance_loop(const TriangleMesh& liver, const TriangleMesh& vein);

}  // namespace glisson::atlas
