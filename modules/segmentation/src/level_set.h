// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "field.h"
#include "glisson/core/run_context.h"

namespace glisson::segmentation {

/// What drives the contour phi = 0 (phi < 0 inside), after Caselles, Kimmel and Sapiro 1997 with the region
/// force of ITK-SNAP (Yushkevich 2006):
///   phi_t = -alpha S |grad phi| + beta kappa |grad phi| + gamma grad g . grad phi.
struct ContourForces {
  Field region;  ///< S in [-1, 1]: positive where the contour should expand
  Field edge;    ///< g in [0, 1]: low on edges, where the contour comes to rest
  double expansion = 1.0, curvature_mm = 0.4, attraction_mm = 0.5;  ///< alpha, beta, gamma
};

/// Sees the contour every few steps.
using ShowContour = std::function<void(const Field& phi)>;

struct ContourSummary {
  int iterations = 0;
  bool converged = false;  ///< the enclosed volume settled
};

/// Half width of the band around the contour in which evolve() leaves distances, in voxels. Beyond it phi
/// says only on which side a place lies.
inline constexpr float kBandVoxels = 3.5F;

/// Signed distance in mm (negative inside) to the boundary of a mask, to about half a voxel.
Field signed_distance(const Mask& mask, const Field& grid);

/// Moves the contour until its volume settles or `iterations` are done. Narrow band, upwind differences,
/// the distance rebuilt every few steps by fast marching from the sub-voxel interface.
Cancellable<ContourSummary> evolve(Field& phi, const ContourForces& forces, int iterations,
                                   const RunContext& context, const ShowContour& show = {});

}  // namespace glisson::segmentation
