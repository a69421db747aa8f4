// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/geometry/ridge_way.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "glisson/core/error.h"
#include "glisson/core/statistics.h"
#include "glisson/geometry/sharpness.h"
#include "glisson/geometry/topology.h"

namespace glisson {
namespace {

constexpr double kEdge = 0.004;  // metres: of the mesh that ways go over
constexpr double kRidge = 0.06;  // sharpness from which on there is a ridge
constexpr double kClimb = 1.02;  // times as sharp is a step up
constexpr double kPull = 4.0;    // exponent of how much dearer a way beside the ridge is
constexpr double kSharp = 0.97;  // of all vertices are less sharp than what counts as a full ridge
constexpr int kSmoothings = 4;   // passes that take the vertices' zigzag away

}  // namespace

RidgeWays::RidgeWays(const TriangleMesh& surface) : mesh_(refined(surface, kEdge)) {
  require(surface.triangle_count() > 0, "ways over a surface need one");
  tree_ = ClosestPointTree(mesh_);
  sharp_ = Sharpness(mesh_).value();
  neighbours_ = vertex_neighbours(mesh_);
  const auto rank = static_cast<std::size_t>(kSharp * static_cast<double>(sharp_.size() - 1));
  const double full = std::max(kRidge, at_rank(sharp_, rank));
  dearness_.reserve(sharp_.size());
  for (const double sharp : sharp_)
    dearness_.push_back(std::exp(kPull * (1.0 - std::clamp(sharp / full, 0.0, 1.0))));
}

int RidgeWays::vertex_at(const Eigen::Vector3d& p) const {
  const ClosestPoint found = tree_.closest(p);
  Eigen::Index corner = 0;
  found.barycentric.maxCoeff(&corner);
  return mesh_.triangles(found.triangle, corner);
}

Eigen::Vector3d RidgeWays::onto_ridge(const Eigen::Vector3d& p, double reach) const {
  const Eigen::Vector3d foot = tree_.closest(p).point;
  int best = -1;
  double most = 0.0;
  for (int v = 0; v < mesh_.vertex_count(); ++v) {
    if (sharp_[v] < kRidge) continue;
    const double share = (mesh_.vertex(v) - foot).norm() / reach;
    // The crest wins over what is closer, until it is nearly out of reach.
    const double score = sharp_[v] * (1.0 - std::pow(share, 6.0));
    if (score <= most) continue;
    most = score;
    best = v;
  }
  if (best < 0) return foot;
  for (bool climbs = true; climbs;) {  // up to the crest, not along it
    climbs = false;
    for (const int w : neighbours_[best]) {
      if (sharp_[w] < kClimb * sharp_[best] || (mesh_.vertex(w) - foot).norm() > reach) continue;
      best = w;
      climbs = true;
      break;
    }
  }
  return mesh_.vertex(best);
}

std::vector<int> RidgeWays::cheapest(int from, int to) const {
  using Entry = std::pair<double, int>;
  std::vector<double> cost(sharp_.size(), std::numeric_limits<double>::infinity());
  std::vector<int> before(sharp_.size(), -1);
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> heap;
  cost[from] = 0.0;
  heap.emplace(0.0, from);
  while (!heap.empty() && heap.top().second != to) {
    const auto [so_far, v] = heap.top();
    heap.pop();
    if (so_far > cost[v]) continue;
    for (const int w : neighbours_[v]) {
      const double next =
          so_far + (mesh_.vertex(v) - mesh_.vertex(w)).norm() * 0.5 * (dearness_[v] + dearness_[w]);
      if (next >= cost[w]) continue;
      cost[w] = next;
      before[w] = v;
      heap.emplace(next, w);
    }
  }
  std::vector<int> way;
  if (from != to && before[to] < 0) return way;
  for (int v = to; v >= 0; v = before[v]) way.push_back(v);
  std::reverse(way.begin(), way.end());
  return way;
}

Points RidgeWays::between(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const {
  const std::vector<int> way = cheapest(vertex_at(from), vertex_at(to));
  // The vertices at both ends stand for the ends themselves.
  const auto inner = way.size() > 2 ? static_cast<Eigen::Index>(way.size()) - 2 : 0;
  Points line(inner + 2, 3);
  line.row(0) = from.transpose();
  line.row(inner + 1) = to.transpose();
  for (Eigen::Index k = 0; k < inner; ++k)
    line.row(k + 1) = mesh_.vertices.row(way[static_cast<std::size_t>(k + 1)]);
  for (int pass = 0; pass < kSmoothings; ++pass) {
    const Points before = line;
    for (Eigen::Index k = 1; k <= inner; ++k)
      line.row(k) = 0.25 * before.row(k - 1) + 0.5 * before.row(k) + 0.25 * before.row(k + 1);
  }
  for (Eigen::Index k = 1; k <= inner; ++k)
    line.row(k) = tree_.closest(line.row(k).transpose()).point.transpose();
  return line;
}

}  // namespace glisson
