// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

class vtkActor;
class vtkRenderer;

namespace glisson::scene {

/// Where one points at when one clicks a place in the view: at the solid thing there, which is seen through a
/// translucent skin; without one at the skin. What is not drawn is not there.
/// @param actors of surfaces in the scene's frame (triangles, metres); a textured one hides what lies behind
/// it but is seen through nothing.
/// @param x, y in [0, 1] from the view's top left corner. @param aspect width over height.
std::optional<Eigen::Vector3d> seen_point(vtkRenderer& renderer, const std::vector<vtkActor*>& actors,
                                          double x, double y, double aspect);

}  // namespace glisson::scene
