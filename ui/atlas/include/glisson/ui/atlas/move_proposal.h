// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/atlas/transfer.h"

namespace glisson::ui {

/// A proposal after a click: a single point lies there; of a line the closest point does, and its neighbours
/// follow less and less; the points of a contact go along as they are. All on the liver's surface.
/// @param to where was clicked, CT frame, metres. @param liver a surface with triangles
/// @return what ReviewProposal takes.
Points moved_points(const atlas::Proposal& proposal, const Eigen::Vector3d& to, const TriangleMesh& liver);

}  // namespace glisson::ui
