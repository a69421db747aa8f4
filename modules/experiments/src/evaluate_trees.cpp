// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluate_trees.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>

namespace glisson::experiments {
namespace {

constexpr double kThick = 2e-3;  // metres: branches that must be found
/// Metres along the true tree beyond which a beam is a bridge between branches. Nearer, siblings leave a fork
/// side by side in the same voxels, and where one begins is a matter of opinion.
constexpr double kFar = 20e-3;

/// A stretch of a true tree between two forks, or a fork and a tip. Metres.
struct Branch {
  std::vector<Eigen::Vector3d> line;
  double radius = 0.0;  ///< mean
};

std::vector<Branch> branches_of(const VesselTree& tree) {
  std::vector<std::vector<int>> children(tree.radii.size());
  for (const auto& [from, to] : tree.beams) children[static_cast<std::size_t>(from)].push_back(to);
  std::vector<Branch> all;
  std::deque<int> starts{tree.root};
  while (!starts.empty()) {
    const int start = starts.front();
    starts.pop_front();
    for (const int child : children[static_cast<std::size_t>(start)]) {
      std::vector<int> nodes{start, child};
      while (children[static_cast<std::size_t>(nodes.back())].size() == 1)
        nodes.push_back(children[static_cast<std::size_t>(nodes.back())].front());
      Branch branch;
      for (std::size_t i = 1; i < nodes.size(); ++i) {
        const Eigen::Vector3d a = tree.nodes.row(nodes[i - 1]).transpose(),
                              b = tree.nodes.row(nodes[i]).transpose();
        const int steps = 1 + static_cast<int>((b - a).norm() / 0.5e-3);
        for (int s = 0; s < steps; ++s) branch.line.emplace_back(a + (b - a) * s / steps);
        branch.radius +=
            tree.radii[static_cast<std::size_t>(nodes[i])] / static_cast<double>(nodes.size() - 1);
      }
      branch.line.emplace_back(tree.nodes.row(nodes.back()).transpose());
      all.push_back(std::move(branch));
      starts.push_back(nodes.back());
    }
  }
  return all;
}

double distance_to(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& p) {
  double least = 1e9;
  for (const Eigen::Vector3d& q : points) least = std::min(least, (p - q).squaredNorm());
  return std::sqrt(least);
}

/// Ways along a tree. Metres.
class Ways {
 public:
  explicit Ways(const VesselTree& tree)
      : tree_(tree),
        parent_(tree.radii.size(), -1),
        depth_(tree.radii.size(), 0),
        from_root_(tree.radii.size(), 0.0) {
    std::vector<std::vector<int>> children(tree.radii.size());
    for (const auto& [from, to] : tree.beams) children[static_cast<std::size_t>(from)].push_back(to);
    std::deque<int> open{tree.root};
    for (; !open.empty(); open.pop_front())
      for (const int child : children[static_cast<std::size_t>(open.front())]) {
        const auto c = static_cast<std::size_t>(child), f = static_cast<std::size_t>(open.front());
        parent_[c] = open.front();
        depth_[c] = depth_[f] + 1;
        from_root_[c] = from_root_[f] + (tree.nodes.row(child) - tree.nodes.row(open.front())).norm();
        open.push_back(child);
      }
  }
  double between(int a, int b) const {
    const double sum = from_root_[static_cast<std::size_t>(a)] + from_root_[static_cast<std::size_t>(b)];
    while (a != b) {
      int& deeper = depth_[static_cast<std::size_t>(a)] >= depth_[static_cast<std::size_t>(b)] ? a : b;
      deeper = parent_[static_cast<std::size_t>(deeper)];
    }
    return sum - 2.0 * from_root_[static_cast<std::size_t>(a)];
  }
  int nearest(const Eigen::Vector3d& p) const {
    Eigen::Index best = 0;
    (tree_.nodes.rowwise() - p.transpose()).rowwise().squaredNorm().minCoeff(&best);
    return static_cast<int>(best);
  }

 private:
  const VesselTree& tree_;
  std::vector<int> parent_, depth_;
  std::vector<double> from_root_;
};

/// The true tree with a node every millimetre, so that its nodes stand for its lines.
VesselTree refined(const VesselTree& tree) {
  VesselTree fine = tree;
  fine.beams.clear();
  std::vector<Eigen::RowVector3d> nodes;
  for (Eigen::Index i = 0; i < tree.nodes.rows(); ++i) nodes.emplace_back(tree.nodes.row(i));
  for (const auto& [a, b] : tree.beams) {
    const int steps = 1 + static_cast<int>((tree.nodes.row(b) - tree.nodes.row(a)).norm() / 1e-3);
    int last = a;
    for (int s = 1; s <= steps; ++s) {
      const int next = s == steps ? b : static_cast<int>(nodes.size());
      if (s < steps) {
        nodes.emplace_back(tree.nodes.row(a) + (tree.nodes.row(b) - tree.nodes.row(a)) * s / steps);
        fine.radii.push_back(tree.radii[static_cast<std::size_t>(b)]);
      }
      fine.beams.push_back({last, next});
      last = next;
    }
  }
  fine.nodes.resize(static_cast<Eigen::Index>(nodes.size()), 3);
  for (std::size_t i = 0; i < nodes.size(); ++i) fine.nodes.row(static_cast<Eigen::Index>(i)) = nodes[i];
  return fine;
}

}  // namespace

TreeScore score_tree(const VesselTree& truth, const std::vector<VesselTree>& found, double voxel,
                     const std::function<bool(const Eigen::Vector3d&)>& in_labels) {
  std::vector<Eigen::Vector3d> true_points, found_points;
  const std::vector<Branch> branches = branches_of(truth);
  for (const Branch& branch : branches)
    true_points.insert(true_points.end(), branch.line.begin(), branch.line.end());
  const VesselTree fine = refined(truth);
  const Ways true_ways(fine);
  TreeScore score;
  int nodes = 0;
  for (const VesselTree& tree : found) {
    if (tree.structure != truth.structure) continue;
    const Ways ways(tree);
    for (int i = 0; i < tree.nodes.rows(); ++i, ++nodes) {
      const double far = distance_to(true_points, tree.nodes.row(i).transpose());
      score.mean += far;
      score.worst = std::max(score.worst, far);
      for (int k = 0; k < i; ++k)
        if ((tree.nodes.row(i) - tree.nodes.row(k)).norm() < voxel &&
            ways.between(i, k) > 6.0 * tree.radii[static_cast<std::size_t>(i)]) {
          ++score.doubled;
          break;
        }
    }
    for (const auto& [a, b] : tree.beams) {
      const Eigen::Vector3d from = tree.nodes.row(a).transpose(), to = tree.nodes.row(b).transpose();
      for (int k = 0; k <= 8; ++k) found_points.emplace_back(from + (to - from) * k / 8.0);
      if (true_ways.between(true_ways.nearest(from), true_ways.nearest(to)) > (to - from).norm() + kFar)
        ++score.bridges;
    }
  }
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  score.mean = nodes > 0 ? score.mean / nodes : unknown;
  if (nodes == 0) score.worst = unknown;
  for (const Branch& branch : branches) {
    if (branch.radius < kThick) continue;
    int inside = 0, near = 0;
    for (const Eigen::Vector3d& p : branch.line) {
      if (!in_labels(p)) continue;
      ++inside;
      near += distance_to(found_points, p) < std::max(voxel, branch.radius);
    }
    if (inside < 2) continue;  // runs outside the liver
    ++score.thick;
    score.thick_found += near >= 0.8 * inside;
  }
  return score;
}

}  // namespace glisson::experiments
