// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

#include "vessel_growth.h"

namespace glisson::insilico {

int GrownTree::terminal_count() const {
  std::vector<char> has_child(nodes.size(), 0);
  for (const int parent : parents)
    if (parent >= 0) has_child[static_cast<std::size_t>(parent)] = 1;
  return static_cast<int>(std::count(has_child.begin(), has_child.end(), 0));
}

void apply_murray(GrownTree& tree, double root_radius) {
  const std::size_t n = tree.nodes.size();
  std::vector<int> terminals(n, 0);
  for (std::size_t i = n; i-- > 0;) {
    if (terminals[i] == 0) terminals[i] = 1;
    if (tree.parents[i] >= 0) terminals[static_cast<std::size_t>(tree.parents[i])] += terminals[i];
  }
  tree.radii.resize(n);
  for (std::size_t i = 0; i < n; ++i)
    tree.radii[i] = root_radius * std::cbrt(static_cast<double>(terminals[i]) / terminals[0]);
}

/// Ericson, Real-Time Collision Detection, 5.1.9.
double segment_distance(const Vec& p1, const Vec& q1, const Vec& p2, const Vec& q2) {
  const Vec d1 = q1 - p1, d2 = q2 - p2, r = p1 - p2;
  const double a = std::max(d1.squaredNorm(), 1e-12), e = std::max(d2.squaredNorm(), 1e-12);
  const double f = d2.dot(r), c = d1.dot(r), b = d1.dot(d2);
  const double denominator = a * e - b * b;
  double s = denominator > 1e-12 ? std::clamp((b * f - c * e) / denominator, 0.0, 1.0) : 0.0;
  double t = (b * s + f) / e;
  if (t < 0.0) {
    t = 0.0;
    s = std::clamp(-c / a, 0.0, 1.0);
  } else if (t > 1.0) {
    t = 1.0;
    s = std::clamp((b - c) / a, 0.0, 1.0);
  }
  return (p1 + s * d1 - p2 - t * d2).norm();
}

double wall_clearance(const GrownTree& a, const GrownTree& b) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 1; i < a.size(); ++i) {
    const auto ii = static_cast<std::size_t>(i), ip = static_cast<std::size_t>(a.parents[ii]);
    for (int j = 1; j < b.size(); ++j) {
      const auto jj = static_cast<std::size_t>(j), jp = static_cast<std::size_t>(b.parents[jj]);
      const double reach = (a.nodes[ii] - b.nodes[jj]).norm() - (a.nodes[ii] - a.nodes[ip]).norm() -
                           (b.nodes[jj] - b.nodes[jp]).norm();
      // Parents are the wider ends; taking their radii keeps the figure on the safe side.
      const double walls = a.radii[ip] + b.radii[jp];
      if (reach - walls >= least) continue;
      least = std::min(least, segment_distance(a.nodes[ip], a.nodes[ii], b.nodes[jp], b.nodes[jj]) - walls);
    }
  }
  return least;
}

}  // namespace glisson::insilico
