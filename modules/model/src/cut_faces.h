// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glisson/geometry/mesh.h"
#include "glisson/patient/cut_organ.h"

namespace glisson::model {

/// Where the image ends inside an organ: a rectangle for each row of faces. CT frame, metres; vertices are
/// not shared. Empty: nowhere.
TriangleMesh cut_faces(const VolumeGrid& grid, const std::vector<CutRow>& rows);

}  // namespace glisson::model
