// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/geometry/mesh.h"
#include "glisson/geometry/rigid.h"
#include "glisson/insilico/tool_use.h"

namespace glisson::insilico {

/// Where a tool is in its use.
struct ToolMoment {
  double out = 1.0;    ///< share of its way out of the picture: 1 before it enters and after it has left
  double share = 0.0;  ///< of the tip's way with the tissue
};
ToolMoment tool_moment(const ToolUse& use, double seconds);

/// A shaft of 5 mm with a round end: the end's outermost point is the origin, the shaft lies along -z.
/// Metres.
TriangleMesh tool_shaft();
/// The shaft with its end at `tip`, coming from `port`, withdrawn by `out` of its whole way out. Any one
/// frame.
TriangleMesh placed_tool(const TriangleMesh& shaft, const Eigen::Vector3d& port, const Eigen::Vector3d& tip,
                         double out);
/// Where the tool comes into the patient: beside the laparoscope, by seed. Left camera's frame of frame 0.
Eigen::Vector3d tool_port(const ToolUse& use);

}  // namespace glisson::insilico
