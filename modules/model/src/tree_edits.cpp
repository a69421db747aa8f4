// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/model/tree_edits.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>

#include "anatomy.h"
#include "glisson/core/error.h"

namespace glisson::model {
namespace {

constexpr double kFarthestPick = 0.020;  // metres from a vessel: farther is a mistake
constexpr double kLongestJoin = 0.060;   // metres
constexpr double kBeamOfJoin = 0.010;    // metres, at most
constexpr double kLeastJoin = 1e-6;      // metres: nearer, the two nodes become one

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
  if (!(least <= kFarthestPick))
    complaint.say(best.node < 0 ? "there is no vessel tree"
                                : "lies " + shown(1e3 * least) + " mm from the nearest vessel",
                  "Point at a vessel of the model");
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

/// Without the branch on which the node lies. Empty: that was the trunk, and all hung on it.
VesselTree pruned(const VesselTree& tree, int node) {
  std::vector<int> parent(tree.radii.size(), -1), children(tree.radii.size(), 0);
  for (const auto& [a, b] : tree.beams) {
    parent[static_cast<std::size_t>(b)] = a;
    ++children[static_cast<std::size_t>(a)];
  }
  // A fork belongs to the branch that leads to it. The branch begins below the next fork towards the root.
  int first = node;
  const auto above = [&](int at) { return parent[static_cast<std::size_t>(at)]; };
  if (first == tree.root) return {};
  while (above(first) != tree.root && children[static_cast<std::size_t>(above(first))] == 1)
    first = above(first);
  if (above(first) == tree.root && children[static_cast<std::size_t>(tree.root)] == 1) return {};
  return from_root(tree, tree.root, [&](int at) { return at != first; });
}

VesselTree joined(const VesselTree& trunk, int at, const VesselTree& other, int to) {
  const VesselTree branch = from_root(other, to, [](int) { return true; });
  const Eigen::RowVector3d a = trunk.nodes.row(at), b = branch.nodes.row(0);
  const double length = (b - a).norm();
  const int between = length < kLeastJoin ? 0 : static_cast<int>(std::ceil(length / kBeamOfJoin)) - 1;
  VesselTree result = trunk;
  const auto count = static_cast<int>(trunk.radii.size());
  result.nodes.conservativeResize(count + between + branch.nodes.rows(), 3);
  int last = at;
  for (int k = 1; k <= between; ++k) {
    const double t = static_cast<double>(k) / (between + 1);
    result.nodes.row(count + k - 1) = a + t * (b - a);
    result.radii.push_back((1.0 - t) * trunk.radii[static_cast<std::size_t>(at)] + t * branch.radii[0]);
    result.beams.push_back({last, count + k - 1});
    last = count + k - 1;
  }
  const int offset = count + between;
  result.nodes.bottomRows(branch.nodes.rows()) = branch.nodes;
  result.radii.insert(result.radii.end(), branch.radii.begin(), branch.radii.end());
  result.beams.push_back({last, offset});
  for (const auto& [from, end] : branch.beams) result.beams.push_back({offset + from, offset + end});
  return from_root(result, result.root, [](int) { return true; });
}

void apply(std::vector<VesselTree>& trees, const TreeEdit& edit, const Complaint& complaint) {
  const Place at = nearest(trees, edit.at, complaint);
  VesselTree& tree = trees[at.tree];
  switch (edit.kind) {
    case TreeEdit::Kind::set_root:
      tree = from_root(tree, at.node, [](int) { return true; });
      return;
    case TreeEdit::Kind::prune:
      tree = pruned(tree, at.node);
      if (tree.beams.empty()) trees.erase(trees.begin() + static_cast<std::ptrdiff_t>(at.tree));
      return;
    case TreeEdit::Kind::join:
      break;
  }
  const Place to = nearest(trees, edit.to, complaint);
  if (to.tree == at.tree)
    complaint.say("both places lie on one tree: a join would close a loop", "Point at two different trees");
  const VesselTree& other = trees[to.tree];
  if (other.structure != tree.structure)
    complaint.say("one place lies on the " + structure_name(tree.structure) + ", the other on the " +
                      structure_name(other.structure),
                  "Join trees of one kind");
  const double apart = (tree.nodes.row(at.node) - other.nodes.row(to.node)).norm();
  if (apart > kLongestJoin)
    complaint.say("the places lie " + shown(1e3 * apart) + " mm apart", "Point at places within 60 mm");
  tree = joined(tree, at.node, other, to.node);
  trees.erase(trees.begin() + static_cast<std::ptrdiff_t>(to.tree));
}

}  // namespace

std::string edit_code(TreeEdit::Kind kind) {
  return kind == TreeEdit::Kind::set_root ? "set_root" : kind == TreeEdit::Kind::prune ? "prune" : "join";
}

std::vector<VesselTree> edited_trees(std::vector<VesselTree> trees, const std::vector<TreeEdit>& edits) {
  for (std::size_t i = 0; i < edits.size(); ++i) apply(trees, edits[i], {i, edits[i].kind});
  return trees;
}

BuiltModel with_tree_edits(const BuiltModel& built, std::vector<TreeEdit> edits) {
  const std::vector<VesselTree>& base = built.tree_edits.empty() ? built.model.vessels : built.trees_as_built;
  BuiltModel result = built;
  result.model.vessels = edited_trees(base, edits);
  result.trees_as_built = edits.empty() ? std::vector<VesselTree>() : base;
  result.tree_edits = std::move(edits);
  std::vector<std::string>& notes = result.report.notes;
  notes.erase(std::remove_if(notes.begin(), notes.end(),
                             [](const std::string& note) {
                               return note.rfind("vessels.beams ", 0) == 0 ||
                                      note.rfind("vessels.nodes_outside_mesh ", 0) == 0;
                             }),
              notes.end());
  count_vessel_nodes(result.model, notes);
  return result;
}

}  // namespace glisson::model
