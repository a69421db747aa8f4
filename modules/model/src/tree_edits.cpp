// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/model/tree_edits.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>

#include "anatomy.h"
#include "glisson/core/error.h"
#include "glisson/model/quality.h"

namespace glisson::model {
namespace {

constexpr double kFarthestPick = 0.020;  // metres from a vessel: farther is a mistake
constexpr double kLongestJoin = 0.060;   // metres
constexpr double kBeamOfJoin = 0.010;    // metres, at most
constexpr double kLeastJoin = 1e-6;      // metres: nearer, the two nodes become one
constexpr double kForkReach = 3e-3;      // metres before a fork, at least, that are meant for a child
constexpr double kAsNear = 0.1e-3;       // metres: no hand tells them apart

struct Place {
  std::size_t tree = 0;
  int node = -1;
};

/// Says which edit cannot be done.
struct Complaint {
  std::size_t number;
  TreeEdit::Kind kind;
  [[noreturn]] void say(const std::string& problem, const std::string& remedy) const {
    throw InputError("tree edits", "edit " + std::to_string(number + 1) + " (" + edit_code(kind) + ")",
                     problem, remedy);
  }
};

[[noreturn]] void say_too_far(const std::vector<VesselTree>& trees, double least,
                              const Complaint& complaint) {
  complaint.say(trees.empty() ? "there is no vessel tree"
                              : "lies " + shown(1e3 * least) + " mm from the nearest vessel",
                "Point at a vessel of the model");
}

Place nearest(const std::vector<VesselTree>& trees, const Eigen::Vector3d& p, const Complaint& complaint) {
  Place best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < trees.size(); ++t)
    for (int i = 0; i < trees[t].nodes.rows(); ++i) {
      const double far = (trees[t].nodes.row(i).transpose() - p).norm();
      if (far >= least) continue;
      least = far;
      best = {t, i};
    }
  if (!(least <= kFarthestPick)) say_too_far(trees, least, complaint);
  return best;
}

std::vector<std::vector<int>> neighbours(const VesselTree& tree) {
  std::vector<std::vector<int>> all(tree.radii.size());
  for (const auto& [a, b] : tree.beams) {
    all[static_cast<std::size_t>(a)].push_back(b);
    all[static_cast<std::size_t>(b)].push_back(a);
  }
  return all;
}

/// The tree from `root` outwards, as far as `keep` allows; nodes in the order in which they are reached.
template <class Keep>
VesselTree from_root(const VesselTree& tree, int root, Keep keep) {
  const auto beside = neighbours(tree);
  std::vector<int> number(tree.radii.size(), -1);
  VesselTree result;
  result.structure = tree.structure;
  result.root = 0;
  std::vector<int> order{root};
  number[static_cast<std::size_t>(root)] = 0;
  for (std::size_t next = 0; next < order.size(); ++next)
    for (const int node : beside[static_cast<std::size_t>(order[next])]) {
      if (number[static_cast<std::size_t>(node)] >= 0 || !keep(node)) continue;
      number[static_cast<std::size_t>(node)] = static_cast<int>(order.size());
      result.beams.push_back({static_cast<int>(next), static_cast<int>(order.size())});
      order.push_back(node);
    }
  result.nodes.resize(static_cast<Eigen::Index>(order.size()), 3);
  for (std::size_t i = 0; i < order.size(); ++i) {
    result.nodes.row(static_cast<Eigen::Index>(i)) = tree.nodes.row(order[i]);
    result.radii.push_back(tree.radii[static_cast<std::size_t>(order[i])]);
  }
  return result;
}

/// A tree's branches: from a fork (or the root) to the next fork or tip.
class Branches {
 public:
  explicit Branches(const VesselTree& tree)
      : tree_(tree), parent_(tree.radii.size(), -1), children_(tree.radii.size()) {
    for (const auto& [a, b] : tree.beams) {
      parent_[static_cast<std::size_t>(b)] = a;
      children_[static_cast<std::size_t>(a)].push_back(b);
    }
  }

  int parent(int node) const { return parent_[static_cast<std::size_t>(node)]; }
  const std::vector<int>& children(int node) const { return children_[static_cast<std::size_t>(node)]; }
  bool is_fork(int node) const { return children(node).size() > 1; }
  /// The branch's node next to the fork or root at which it begins.
  int begin(int node) const {
    while (parent(node) >= 0 && parent(node) != tree_.root && !is_fork(parent(node))) node = parent(node);
    return node;
  }
  /// The fork or tip at which the branch ends.
  int end(int node) const {
    while (children(node).size() == 1) node = children(node).front();
    return node;
  }
  /// Metres along the branch from a node down to one of the nodes that follow.
  double way(int from, int to) const {
    double sum = 0.0;
    for (; to != from; to = parent(to)) sum += (tree_.nodes.row(to) - tree_.nodes.row(parent(to))).norm();
    return sum;
  }
  /// Of a point from the branch that begins with the beam to `node`.
  double distance(const Eigen::Vector3d& p, int node) const {
    double least = std::numeric_limits<double>::infinity();
    for (;; node = children(node).front()) {
      const Eigen::Vector3d a = tree_.nodes.row(parent(node)).transpose(),
                            b = tree_.nodes.row(node).transpose();
      least = std::min(least, (p - a - share_along(p, a, b) * (b - a)).norm());
      if (children(node).size() != 1) return least;
    }
  }
  /// What goes with a node, hanging on the node before it.
  VesselTree part(int first) const {
    if (first == tree_.root) return from_root(tree_, first, [](int) { return true; });
    std::vector<char> goes(tree_.radii.size(), 0);
    std::vector<int> open{first};
    while (!open.empty()) {
      const int node = open.back();
      open.pop_back();
      goes[static_cast<std::size_t>(node)] = 1;
      open.insert(open.end(), children(node).begin(), children(node).end());
    }
    return from_root(tree_, parent(first),
                     [&](int node) { return goes[static_cast<std::size_t>(node)] != 0; });
  }
  /// The child of a fork that a click there means.
  int child_at(int fork, const Eigen::Vector3d& p) const {
    int best = -1;
    double least = 0.0, least_length = 0.0;
    for (const int child : children(fork)) {
      const double far = distance(p, child), length = tree_summary(part(child)).length;
      const bool as_near = best >= 0 && std::abs(far - least) <= kAsNear;
      if (best >= 0 && (as_near ? length >= least_length : far > least)) continue;
      best = child;
      least = far;
      least_length = length;
    }
    return best;
  }

  /// 0 at `a`, 1 at `b`, of the point of the line between them that is nearest to `p`.
  static double share_along(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    const double squared = (b - a).squaredNorm();
    return squared > 0.0 ? std::clamp((p - a).dot(b - a) / squared, 0.0, 1.0) : 0.0;
  }

 private:
  const VesselTree& tree_;
  std::vector<int> parent_;
  std::vector<std::vector<int>> children_;
};

/// The node next to the root that goes, for a click whose nearest point lies on the beam from a to b.
int first_to_go(const VesselTree& tree, const std::array<int, 2>& beam, double share,
                const Eigen::Vector3d& p) {
  const Branches branches(tree);
  const auto [a, b] = beam;
  const double length = (tree.nodes.row(b) - tree.nodes.row(a)).norm();
  if (branches.is_fork(a) && share * length <= kAsNear) return branches.child_at(a, p);
  const int begin = branches.begin(b), end = branches.end(b);
  if (branches.is_fork(end)) {
    const double before = (1.0 - share) * length + branches.way(b, end);
    const double reach = std::min(std::max(kForkReach, tree.radii[static_cast<std::size_t>(end)]),
                                  0.5 * branches.way(branches.parent(begin), end));
    if (before <= reach) return branches.child_at(end, p);
  }
  const bool trunk = branches.parent(begin) == tree.root && !branches.is_fork(tree.root);
  return trunk ? tree.root : begin;
}

Pruning pruning(const std::vector<VesselTree>& trees, const Eigen::Vector3d& p, const Complaint& complaint) {
  Pruning result;
  std::array<int, 2> beam{};
  double least = std::numeric_limits<double>::infinity(), share = 0.0;
  for (std::size_t t = 0; t < trees.size(); ++t)
    for (const auto& [a, b] : trees[t].beams) {
      const Eigen::Vector3d from = trees[t].nodes.row(a).transpose(), to = trees[t].nodes.row(b).transpose();
      const double along = Branches::share_along(p, from, to);
      const double far = (p - from - along * (to - from)).norm();
      if (far >= least) continue;
      least = far;
      share = along;
      beam = {a, b};
      result.tree = t;
    }
  if (!(least <= kFarthestPick)) say_too_far(trees, least, complaint);
  const VesselTree& tree = trees[result.tree];
  result.first = first_to_go(tree, beam, share, p);
  result.whole_tree = result.first == tree.root;
  result.part = Branches(tree).part(result.first);
  return result;
}

/// What a join hangs on the trunk: node 0 is the trunk's node `at`, then comes the link, then the other tree
/// from its node `to` outwards.
VesselTree hanging(const VesselTree& trunk, int at, const VesselTree& other, int to) {
  const VesselTree branch = from_root(other, to, [](int) { return true; });
  const Eigen::RowVector3d a = trunk.nodes.row(at), b = branch.nodes.row(0);
  const double length = (b - a).norm();
  const int between = length < kLeastJoin ? 0 : static_cast<int>(std::ceil(length / kBeamOfJoin)) - 1;
  const int offset = between + 1;
  VesselTree part;
  part.structure = trunk.structure;
  part.root = 0;
  part.nodes.resize(offset + branch.nodes.rows(), 3);
  part.nodes.row(0) = a;
  part.radii.push_back(trunk.radii[static_cast<std::size_t>(at)]);
  for (int k = 1; k <= between; ++k) {
    const double t = static_cast<double>(k) / (between + 1);
    part.nodes.row(k) = a + t * (b - a);
    part.radii.push_back((1.0 - t) * part.radii[0] + t * branch.radii[0]);
    part.beams.push_back({k - 1, k});
  }
  part.nodes.bottomRows(branch.nodes.rows()) = branch.nodes;
  part.radii.insert(part.radii.end(), branch.radii.begin(), branch.radii.end());
  part.beams.push_back({between, offset});
  for (const auto& [from, end] : branch.beams) part.beams.push_back({offset + from, offset + end});
  return part;
}

/// The trunk with such a part hung on its node `at`.
VesselTree joined(const VesselTree& trunk, int at, const VesselTree& part) {
  VesselTree result = trunk;
  const auto count = static_cast<int>(trunk.radii.size());
  const auto number = [&](int node) { return node == 0 ? at : count + node - 1; };
  const Eigen::Index more = part.nodes.rows() - 1;
  result.nodes.conservativeResize(count + more, 3);
  result.nodes.bottomRows(more) = part.nodes.bottomRows(more);
  result.radii.insert(result.radii.end(), part.radii.begin() + 1, part.radii.end());
  for (const auto& [from, to] : part.beams) result.beams.push_back({number(from), number(to)});
  return from_root(result, result.root, [](int) { return true; });
}

Joining joining(const std::vector<VesselTree>& trees, const Place& at, const Place& to) {
  Joining result;
  result.stays = at.tree;
  result.hangs = to.tree;
  const VesselTree &tree = trees[at.tree], &other = trees[to.tree];
  result.link = (tree.nodes.row(at.node) - other.nodes.row(to.node)).norm();
  using Obstacle = Joining::Obstacle;
  result.obstacle = to.tree == at.tree                  ? Obstacle::one_tree
                    : other.structure != tree.structure ? Obstacle::two_kinds
                    : result.link > kLongestJoin        ? Obstacle::too_far
                                                        : Obstacle::none;
  if (result.obstacle == Obstacle::none) result.part = hanging(tree, at.node, other, to.node);
  return result;
}

void join(std::vector<VesselTree>& trees, const TreeEdit& edit, const Complaint& complaint) {
  const Place at = nearest(trees, edit.at, complaint);
  const Joining join = joining(trees, at, nearest(trees, edit.to, complaint));
  VesselTree& tree = trees[join.stays];
  switch (join.obstacle) {
    case Joining::Obstacle::one_tree:
      complaint.say("both places lie on one tree: a join would close a loop", "Point at two different trees");
    case Joining::Obstacle::two_kinds:
      complaint.say("one place lies on the " + structure_name(tree.structure) + ", the other on the " +
                        structure_name(trees[join.hangs].structure),
                    "Join trees of one kind");
    case Joining::Obstacle::too_far:
      complaint.say("the places lie " + shown(1e3 * join.link) + " mm apart", "Point at places within 60 mm");
    case Joining::Obstacle::none:
      break;
  }
  tree = joined(tree, at.node, join.part);
  trees.erase(trees.begin() + static_cast<std::ptrdiff_t>(join.hangs));
}

void prune(std::vector<VesselTree>& trees, const Eigen::Vector3d& at, const Complaint& complaint) {
  const Pruning cut = pruning(trees, at, complaint);
  VesselTree& tree = trees[cut.tree];
  if (cut.whole_tree)
    trees.erase(trees.begin() + static_cast<std::ptrdiff_t>(cut.tree));
  else
    tree = from_root(tree, tree.root, [&](int node) { return node != cut.first; });
}

void apply(std::vector<VesselTree>& trees, const TreeEdit& edit, const Complaint& complaint) {
  if (edit.kind == TreeEdit::Kind::prune) return prune(trees, edit.at, complaint);
  if (edit.kind == TreeEdit::Kind::join) return join(trees, edit, complaint);
  const Place at = nearest(trees, edit.at, complaint);
  trees[at.tree] = from_root(trees[at.tree], at.node, [](int) { return true; });
}

}  // namespace

std::string edit_code(TreeEdit::Kind kind) {
  return kind == TreeEdit::Kind::set_root ? "set_root" : kind == TreeEdit::Kind::prune ? "prune" : "join";
}

Pruning pruning_at(const std::vector<VesselTree>& trees, const Eigen::Vector3d& at) {
  return pruning(trees, at, {0, TreeEdit::Kind::prune});
}

Joining joining_at(const std::vector<VesselTree>& trees, const Eigen::Vector3d& at,
                   const Eigen::Vector3d& to) {
  const Complaint complaint{0, TreeEdit::Kind::join};
  return joining(trees, nearest(trees, at, complaint), nearest(trees, to, complaint));
}

BuiltModel with_tree_edits(const BuiltModel& built, std::vector<TreeEdit> edits) {
  const std::vector<VesselTree>& base = built.tree_edits.empty() ? built.model.vessels : built.trees_as_built;
  BuiltModel result = built;
  std::vector<std::string> cuts;
  std::vector<VesselTree> trees = base;
  for (std::size_t i = 0; i < edits.size(); ++i) {
    const Complaint complaint{i, edits[i].kind};
    if (edits[i].kind == TreeEdit::Kind::prune) {
      const TreeSummary cut = tree_summary(pruning(trees, edits[i].at, complaint).part);
      cuts.push_back("vessels.pruned_by_hand " + structure_name(cut.structure) + " mm " +
                     shown(1e3 * cut.length) + " tips " + std::to_string(cut.tips));
    }
    apply(trees, edits[i], complaint);
  }
  result.model.vessels = std::move(trees);
  result.trees_as_built = edits.empty() ? std::vector<VesselTree>() : base;
  result.tree_edits = std::move(edits);
  std::vector<std::string>& notes = result.report.notes;
  notes.erase(std::remove_if(notes.begin(), notes.end(),
                             [](const std::string& note) {
                               return note.rfind("vessels.beams ", 0) == 0 ||
                                      note.rfind("vessels.pruned_by_hand ", 0) == 0 ||
                                      note.rfind("vessels.nodes_outside_mesh ", 0) == 0;
                             }),
              notes.end());
  notes.insert(notes.end(), cuts.begin(), cuts.end());
  count_vessel_nodes(result.model, notes);
  return result;
}

}  // namespace glisson::model
