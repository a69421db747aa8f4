// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface_field.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "glisson/core/error.h"
#include "glisson/geometry/topology.h"
#include "mesh_to_size.h"

namespace glisson::model {
namespace {

constexpr double kSpeck = 0.01;  // of the largest piece's volume
constexpr double kMostSamples = 2e6;
constexpr double kEdgeOverSpacing = 8.0;

std::string millilitres(double cubic_metres) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g ml", std::abs(cubic_metres) * 1e6);
  return text;
}

void turn_outwards(TriangleMesh& mesh) {
  if (volume(mesh) < 0.0) mesh.triangles.col(1).swap(mesh.triangles.col(2));
}

}  // namespace

TriangleMesh largest_closed_piece(const TriangleMesh& surface, const std::string& name,
                                  std::vector<double>* dropped_ml) {
  if (surface.triangle_count() == 0)
    throw InputError(name, "triangles", "there are none", "Give a closed surface");
  if (!surface.vertices.allFinite())
    throw InputError(name, "vertices", "a coordinate is not a finite number", "Export the surface anew");
  std::vector<TriangleMesh> pieces = split_components(merge_vertices(surface, 0.0));
  if (pieces.empty()) throw InputError(name, "triangles", "all are degenerate", "Export the surface anew");
  TriangleMesh largest = std::move(pieces.front());
  if (!is_closed(largest))
    throw InputError(name, "surface", "has holes or edges with more than two triangles",
                     "Close it (fill its holes) before it is meshed");
  const double whole = std::abs(volume(largest));
  if (!(whole > 0.0)) throw InputError(name, "surface", "encloses no volume", "Give a closed surface");
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    const double part = std::abs(volume(pieces[i]));
    if (part > kSpeck * whole)
      throw InputError(name, "surface",
                       "has several large pieces (" + millilitres(whole) + " and " + millilitres(part) + ")",
                       "Keep the one that is the liver, or join them");
    if (dropped_ml != nullptr) dropped_ml->push_back(part * 1e6);
  }
  turn_outwards(largest);
  return largest;
}

double body_spacing_mm(const TriangleMesh& surface, const MeshOptions& options) {
  const Eigen::Vector3d box =
      1e3 * (surface.vertices.colwise().maxCoeff() - surface.vertices.colwise().minCoeff()).transpose();
  const double edge = 1e3 * typical_edge(std::abs(volume(surface)), options);
  return std::max(edge / kEdgeOverSpacing, std::cbrt(box.prod() / kMostSamples));
}

}  // namespace glisson::model
