// SPDX-License-Identifier: GPL-3.0-or-later
#include "close_holes.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <utility>
#include <vector>

#include "glisson/geometry/topology.h"

namespace glisson::model {
namespace {

/// An edge between two vertices, a < b.
struct Rim {
  int a = 0, b = 0;
  int runs = 0;  ///< triangles that run along it from a to b, less those from b to a
};

/// The edges at which the triangles' directions do not cancel.
std::vector<Rim> rims_of(const TriangleMesh& surface) {
  std::vector<Rim> all;
  all.reserve(static_cast<std::size_t>(surface.triangle_count()) * 3);
  for (int t = 0; t < surface.triangle_count(); ++t)
    for (int k = 0; k < 3; ++k) {
      const int a = surface.triangles(t, k), b = surface.triangles(t, (k + 1) % 3);
      all.push_back({std::min(a, b), std::max(a, b), a < b ? 1 : -1});
    }
  const auto ends = [](const Rim& rim) { return std::pair(rim.a, rim.b); };
  std::ranges::sort(all, {}, ends);
  std::vector<Rim> rims;
  for (std::size_t i = 0; i < all.size();) {
    Rim sum{all[i].a, all[i].b, 0};
    for (; i < all.size() && ends(all[i]) == ends(sum); ++i) sum.runs += all[i].runs;
    if (sum.runs != 0) rims.push_back(sum);
  }
  return rims;
}

}  // namespace

bool close_holes(TriangleMesh& surface) {
  const std::vector<Rim> rims = rims_of(surface);
  if (rims.empty()) return false;
  // Edges that hang together are one rim: as flat triangles, they are a mesh with its pieces.
  TriangleMesh edges;
  edges.vertices = surface.vertices;
  edges.triangles.resize(static_cast<Eigen::Index>(rims.size()), 3);
  std::vector<int> all;
  for (std::size_t r = 0; r < rims.size(); ++r) {
    edges.triangles.row(static_cast<Eigen::Index>(r)) << rims[r].a, rims[r].b, rims[r].b;
    all.push_back(static_cast<int>(r));
  }
  edges = select_triangles(edges, all);
  int count = 0;
  const std::vector<int> rim_of = connected_components(edges, &count);
  const auto number = [&](std::size_t r) { return rim_of[edges.triangles(static_cast<Eigen::Index>(r), 0)]; };
  // Weighted by length: how finely a rim is cut does not move its middle.
  Points sums = Points::Zero(count, 3);
  Eigen::VectorXd lengths = Eigen::VectorXd::Zero(count);
  Eigen::Index added = 0;
  for (std::size_t r = 0; r < rims.size(); ++r) {
    const Eigen::Vector3d a = surface.vertex(rims[r].a), b = surface.vertex(rims[r].b);
    sums.row(number(r)) += (0.5 * (a - b).norm() * (a + b)).transpose();
    lengths[number(r)] += (a - b).norm();
    added += std::abs(rims[r].runs);
  }
  const int first = surface.vertex_count();
  Eigen::Index next = surface.triangles.rows();
  surface.vertices.conservativeResize(first + count, 3);
  surface.vertices.bottomRows(count) =
      sums.array().colwise() / lengths.array().max(std::numeric_limits<double>::min());
  surface.triangles.conservativeResize(next + added, 3);
  for (std::size_t r = 0; r < rims.size(); ++r) {
    const bool forth = rims[r].runs > 0;
    for (int run = 0; run < std::abs(rims[r].runs); ++run)
      surface.triangles.row(next++) << (forth ? rims[r].b : rims[r].a), (forth ? rims[r].a : rims[r].b),
          first + number(r);
  }
  return true;
}

}  // namespace glisson::model
