// SPDX-License-Identifier: GPL-3.0-or-later
#include "vessel_growth.h"

#include <limits>

namespace glisson::insilico {

namespace {

constexpr double kStep = 4.0;          ///< between nodes
constexpr double kCapsuleDepth = 4.0;  ///< of any centreline below the surface
constexpr double kBranchRadius = 1.6;  ///< assumed of a branch whose radius is not yet known
constexpr double kWayShare = 0.28;     ///< weight of the way from the root against the new length

/// Catmull-Rom through the points, about kStep apart; the first point itself is left out.
std::vector<Vec> curve_through(const std::vector<Vec>& points) {
  std::vector<Vec> curve;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Vec& p1 = points[i];
    const Vec& p2 = points[i + 1];
    const Vec p0 = i > 0 ? points[i - 1] : Vec(2.0 * p1 - p2);
    const Vec p3 = i + 2 < points.size() ? points[i + 2] : Vec(2.0 * p2 - p1);
    const int steps = std::max(1, static_cast<int>(std::lround((p2 - p1).norm() / kStep)));
    for (int k = 1; k <= steps; ++k) {
      const double t = static_cast<double>(k) / steps;
      curve.push_back(0.5 * (2.0 * p1 + t * (p2 - p0) + t * t * (2.0 * p0 - 5.0 * p1 + 4.0 * p2 - p3) +
                             t * t * t * (3.0 * p1 - p0 - 3.0 * p2 + p3)));
    }
  }
  return curve;
}

/// Appends a branch through `points` (the first is the node `from` itself). @return its last node.
int lay(GrownTree& tree, int from, const std::vector<Vec>& points, bool outside = false) {
  for (const Vec& p : curve_through(points)) {
    tree.nodes.push_back(p);
    tree.parents.push_back(from);
    tree.outside.push_back(outside ? 1 : 0);
    from = tree.size() - 1;
  }
  return from;
}

Vec node(const GrownTree& tree, int i) { return tree.nodes[static_cast<std::size_t>(i)]; }

GrownTree portal_main(const LiverShape& shape) {
  const ShapeParameters& s = shape.parameters();
  GrownTree tree;
  const Vec hilum = shape.hilum();
  const Vec start = hilum + Vec(20.0, 4.0, -44.0);
  tree.nodes = {start};
  tree.parents = {-1};
  tree.outside = {1};
  const Vec fork = hilum + Vec(-3.0, -2.0, 13.0);
  const int gate =
      lay(tree, 0, {start, mix_points(start, hilum, 0.55) + Vec(-1, 2, 0), hilum + Vec(1, 0, -1)}, true);
  const int main_fork = lay(tree, gate, {node(tree, gate), fork});
  const double nx = s.notch_x;
  // Right: a short trunk, then the anterior sector upwards and to the front, the posterior one backwards.
  const Vec right = shape.point_inside(-46, -2, 0.40);
  const int right_fork = lay(tree, main_fork, {fork, 0.5 * (fork + right) + Vec(0, 0, 3), right});
  lay(tree, right_fork,
      {right, shape.point_inside(-66, -22, 0.50), shape.point_inside(-78, -34, 0.66),
       shape.point_inside(-82, -36, 0.82)});
  lay(tree, right_fork,
      {right, shape.point_inside(-72, 22, 0.36), shape.point_inside(-94, 32, 0.40),
       shape.point_inside(-104, 28, 0.52)});
  // Left: along the base of segment 4, then forwards in the umbilical fissure.
  const Vec umbilical = shape.point_inside(nx + 8, -28, 0.40);
  const int left_fork = lay(tree, main_fork, {fork, fork + Vec(10, -6, 5), umbilical});
  lay(tree, left_fork,
      {umbilical, shape.point_inside(nx + 4, -42, 0.46), shape.point_inside(nx - 3, -55, 0.52)});
  lay(tree, left_fork,
      {umbilical, shape.point_inside(nx + 28, -34, 0.42), shape.point_inside(nx + 46, -38, 0.45)});
  return tree;
}

GrownTree hepatic_main(const LiverShape& shape) {
  GrownTree tree;
  const auto top = shape.extent_at(-30, 4).second;
  const Vec start = shape.cava_centre(top - 14.0);
  tree.nodes = {start};
  tree.parents = {-1};
  tree.outside = {1};
  const double reach = shape.parameters().cava_radius + 3.0;
  const Vec right_mouth = start + Vec(-0.92 * reach, -0.30 * reach, -2.0);
  const Vec left_mouth = start + Vec(0.10 * reach, -1.0 * reach, -2.0);
  // Right vein between the anterior and the posterior sector.
  const int right = lay(tree, 0, {start, right_mouth}, true);
  lay(tree, right,
      {right_mouth, shape.point_inside(-56, 12, 0.80), shape.point_inside(-80, 8, 0.62),
       shape.point_inside(-98, 0, 0.42), shape.point_inside(-106, -8, 0.26)});
  // Middle and left veins share a trunk, as in most people.
  const int left = lay(tree, 0, {start, left_mouth}, true);
  const Vec trunk = shape.point_inside(-14, -10, 0.78);
  const int fork = lay(tree, left, {left_mouth, trunk});
  lay(tree, fork,
      {trunk, shape.point_inside(-26, -28, 0.68), shape.point_inside(-36, -46, 0.52),
       shape.point_inside(-44, -60, 0.34)});
  lay(tree, fork,
      {trunk, shape.point_inside(10, -22, 0.80), shape.point_inside(28, -34, 0.74),
       shape.point_inside(44, -46, 0.70)});
  return tree;
}

/// Everything that decides where a branch may go.
class Growth {
 public:
  Growth(const LiverShape& shape, const std::vector<Lesion>& lesions, const GrowthOptions& options,
         Dice& dice)
      : shape_(shape), lesions_(lesions), options_(options), dice_(dice) {}

  /// Tries one random terminal, at least `apart` from what is there. @return whether it was joined.
  bool add_terminal(GrownTree& tree, const GrownTree& other, double apart) const;

 private:
  bool free_at(const Vec& p, const GrownTree& other, double radius) const;
  bool may_pass(const std::vector<Vec>& path, const GrownTree& tree, int joint, const GrownTree& other) const;
  std::vector<Vec> path_to(const GrownTree& tree, int joint, const Vec& target) const;

  const LiverShape& shape_;
  const std::vector<Lesion>& lesions_;
  const GrowthOptions& options_;
  Dice& dice_;
};

bool Growth::free_at(const Vec& p, const GrownTree& other, double radius) const {
  for (std::size_t i = 0; i < other.nodes.size(); ++i) {
    // Half a step more, because the wall may bulge between two nodes.
    const double least = std::max(other.radii[i], kBranchRadius) + radius + options_.clearance + 0.6;
    if ((other.nodes[i] - p).squaredNorm() < least * least) return false;
  }
  if (shape_.liver(p) > -kCapsuleDepth) return false;
  return std::all_of(lesions_.begin(), lesions_.end(), [&](const Lesion& lesion) {
    return (p - lesion.centre).norm() > lesion.reach() + radius + 2.0;
  });
}

std::vector<Vec> Growth::path_to(const GrownTree& tree, int joint, const Vec& target) const {
  const Vec from = node(tree, joint);
  const int parent = tree.parents[static_cast<std::size_t>(joint)];
  const Vec along =
      parent < 0 ? Vec((target - from).normalized()) : Vec((from - node(tree, parent)).normalized());
  const double length = (target - from).norm();
  // Leaves between its parent's direction and its own, then bends to the target.
  const Vec control = from + 0.45 * length * (0.5 * along + 0.9 * (target - from) / length).normalized();
  const int steps = std::max(2, static_cast<int>(std::lround(length / kStep)));
  std::vector<Vec> path;
  for (int k = 1; k <= steps; ++k) {
    const double t = static_cast<double>(k) / steps;
    path.push_back((1 - t) * (1 - t) * from + 2 * t * (1 - t) * control + t * t * target);
  }
  return path;
}

bool Growth::may_pass(const std::vector<Vec>& path, const GrownTree& tree, int joint,
                      const GrownTree& other) const {
  const double around_joint = tree.radii[static_cast<std::size_t>(joint)] + 6.0;
  for (const Vec& p : path) {
    if (!free_at(p, other, kBranchRadius)) return false;
    if ((p - node(tree, joint)).norm() < around_joint) continue;
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
      const double least = tree.radii[i] + kBranchRadius + 2.0;
      if ((tree.nodes[i] - p).squaredNorm() < least * least) return false;
    }
  }
  return true;
}

bool Growth::add_terminal(GrownTree& tree, const GrownTree& other, double apart) const {
  const Vec target = dice_.inside(shape_.low(), shape_.high());
  if (shape_.liver(target) > -kCapsuleDepth - 2.0) return false;
  for (const Vec& p : tree.nodes)
    if ((p - target).squaredNorm() < apart * apart) return false;
  if (!free_at(target, other, kBranchRadius)) return false;

  std::vector<double> way(tree.nodes.size(), 0.0);
  std::vector<std::pair<double, int>> joints;
  for (int i = 1; i < tree.size(); ++i) {
    const auto ii = static_cast<std::size_t>(i), ip = static_cast<std::size_t>(tree.parents[ii]);
    way[ii] = way[ip] + (tree.nodes[ii] - tree.nodes[ip]).norm();
    if (tree.outside[ii]) continue;
    const Vec to = target - tree.nodes[ii];
    const double forward = to.normalized().dot((tree.nodes[ii] - tree.nodes[ip]).normalized());
    if (forward < 0.1) continue;
    joints.emplace_back(to.norm() * (1.0 + 0.25 * (1.0 - forward)) + kWayShare * way[ii], i);
  }
  const std::size_t tried = std::min<std::size_t>(joints.size(), 14);
  std::partial_sort(joints.begin(), joints.begin() + static_cast<std::ptrdiff_t>(tried), joints.end());
  for (std::size_t k = 0; k < tried; ++k) {
    const int joint = joints[k].second;
    const std::vector<Vec> path = path_to(tree, joint, target);
    if (!may_pass(path, tree, joint, other)) continue;
    int from = joint;
    for (const Vec& p : path) {
      tree.nodes.push_back(p);
      tree.parents.push_back(from);
      tree.radii.push_back(kBranchRadius);
      tree.outside.push_back(0);
      from = tree.size() - 1;
    }
    return true;
  }
  return false;
}

/// Drops the marked nodes with all that hangs on them.
GrownTree without(const GrownTree& tree, std::vector<char> drop) {
  GrownTree kept;
  std::vector<int> index(tree.nodes.size(), -1);
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    const int parent = tree.parents[i];
    if (parent >= 0 && drop[static_cast<std::size_t>(parent)]) drop[i] = 1;
    if (drop[i]) continue;
    index[i] = kept.size();
    kept.nodes.push_back(tree.nodes[i]);
    kept.parents.push_back(parent < 0 ? -1 : index[static_cast<std::size_t>(parent)]);
    kept.radii.push_back(tree.radii[i]);
    kept.outside.push_back(tree.outside[i]);
  }
  return kept;
}

/// Prunes the thinner of two branches that came too near each other, or a vessel too near the capsule or a
/// lesion.
/// @return whether anything was pruned.
bool prune(GrownTree& tree, const GrownTree& other, const LiverShape& shape,
           const std::vector<Lesion>& lesions, double clearance) {
  std::vector<char> drop(tree.nodes.size(), 0);
  bool any = false;
  for (std::size_t i = 1; i < tree.nodes.size(); ++i) {
    if (tree.outside[i]) continue;
    const Vec& p = tree.nodes[i];
    const double radius = tree.radii[static_cast<std::size_t>(tree.parents[i])];
    bool bad = radius < 2.0 && shape.liver(p) > -radius - 1.0;
    for (const Lesion& lesion : lesions) bad |= (p - lesion.centre).norm() < lesion.reach() + radius + 0.8;
    for (std::size_t j = 1; j < other.nodes.size() && !bad; ++j) {
      const auto parent = static_cast<std::size_t>(other.parents[j]);
      if (radius > other.radii[parent] || (p - other.nodes[j]).norm() > 40.0) continue;
      bad = segment_distance(tree.nodes[static_cast<std::size_t>(tree.parents[i])], p, other.nodes[parent],
                             other.nodes[j]) < radius + other.radii[parent] + clearance;
    }
    if (bad) drop[i] = 1, any = true;
  }
  if (any) tree = without(tree, drop);
  return any;
}

}  // namespace

GrownTrees main_branches(const LiverShape& shape, const GrowthOptions& options) {
  GrownTrees trees{portal_main(shape), hepatic_main(shape)};
  apply_murray(trees.portal, 0.8 * options.portal_root_radius);
  apply_murray(trees.hepatic, 0.8 * options.hepatic_root_radius);
  return trees;
}

Cancellable<GrownTrees> grow_trees(const LiverShape& shape, const std::vector<Lesion>& lesions,
                                   const GrowthOptions& options, const RunContext& context) {
  Dice dice(RunContext({}, nullptr, shape.parameters().seed).random("insilico.vessels"));
  GrownTrees trees = main_branches(shape, options);
  const Growth growth(shape, lesions, options, dice);
  // Wide apart first: the early branches become the large ones.
  double apart = 26.0;
  int failures = 0;
  while (apart > 7.5) {
    if (context.cancelled()) return {};
    const bool portal = trees.portal.terminal_count() <= trees.hepatic.terminal_count();
    GrownTree& tree = portal ? trees.portal : trees.hepatic;
    if (tree.terminal_count() >= options.terminals) break;
    const bool joined = growth.add_terminal(tree, portal ? trees.hepatic : trees.portal, apart);
    failures = joined ? 0 : failures + 1;
    if (failures > 250) {
      apart *= 0.9;
      failures = 0;
      context.progress(std::clamp((26.0 - apart) / 18.5, 0.0, 1.0), "patient.vessels");
    }
  }
  for (int round = 0; round < 12; ++round) {
    apply_murray(trees.portal, options.portal_root_radius);
    apply_murray(trees.hepatic, options.hepatic_root_radius);
    const bool portal = prune(trees.portal, trees.hepatic, shape, lesions, options.clearance);
    const bool hepatic = prune(trees.hepatic, trees.portal, shape, lesions, options.clearance);
    if (!portal && !hepatic) break;
  }
  apply_murray(trees.portal, options.portal_root_radius);
  apply_murray(trees.hepatic, options.hepatic_root_radius);
  return trees;
}

}  // namespace glisson::insilico
