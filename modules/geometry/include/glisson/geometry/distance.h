// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glisson/geometry/mesh.h"

namespace glisson {

/// Summary of unsigned distances, metres.
struct DistanceSummary {
  double mean = 0.0, rms = 0.0, median = 0.0, percentile_95 = 0.0, maximum = 0.0;
  int count = 0;
};
/// @param distances any order; empty gives zeros.
DistanceSummary summarise(std::vector<double> distances);

/// Distance of each point to the closest point of the surface, metres.
std::vector<double> distances_to_surface(const Points& points, const TriangleMesh& surface);

/// Points spread evenly over a surface: one at random in each of `count` parts of equal area. The same seed
/// gives the same points. @pre count >= 0; the surface has an area.
Points sample_surface(const TriangleMesh& surface, int count, unsigned seed);

/// Both directions, from `samples` points on each surface. (The paper's "mean Hausdorff distance" is another
/// figure: the mean of distances_to_surface() from the mesh's boundary nodes to the fine surface.)
struct SurfaceDistance {
  DistanceSummary forward;   ///< a to b
  DistanceSummary backward;  ///< b to a
};
/// Metres; the same meshes give the same figures. @pre both surfaces have an area.
SurfaceDistance surface_distance(const TriangleMesh& a, const TriangleMesh& b, int samples = 20000);

/// Between two sets of points, each point to the closest one of the other set, metres.
struct SetDistance {
  double mean = 0.0;     ///< half the sum of both directions' means
  double largest = 0.0;  ///< of either direction: the Hausdorff distance
};
/// Infinite where a set is empty.
SetDistance set_distance(const Points& a, const Points& b);

/// |a_i - b_i| row by row, summarised. @pre same number of rows.
DistanceSummary point_errors(const Points& a, const Points& b);

}  // namespace glisson
