// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "glisson/model/build.h"

/// @file
/// What a person changes in the vessel trees of a model. Edits are a list that is replayed on the trees as
/// they were built: undo is the list without its last.

namespace glisson::model {

/// "set_root", "prune", "join".
std::string edit_code(TreeEdit::Kind kind);

/// What an edit "prune" would take away.
struct Pruning {
  std::size_t tree = 0;     ///< index among the trees given
  int first = -1;           ///< of the nodes that go the one next to the root; the root: the whole tree goes
  VesselTree part;          ///< what goes. Its node 0 is where it hangs on the tree; that node stays
  bool whole_tree = false;  ///< the branch is the trunk, on which all hangs
};
/// What a click at `at` (CT frame, metres) prunes: the branch whose centreline is nearest, from its fork on,
/// with all that hangs on it. A click at a fork (up to 3 mm or its radius before it, or half the branch that
/// leads there) means the child nearest to the click, of several as near the one with the least on it, never
/// the branch that leads to the fork.
/// @throws InputError no vessel within 20 mm.
Pruning pruning_at(const std::vector<VesselTree>& trees, const Eigen::Vector3d& at);

/// What an edit "join" would do.
struct Joining {
  enum class Obstacle { none, one_tree, two_kinds, too_far };
  Obstacle obstacle = Obstacle::none;  ///< why it cannot be done
  std::size_t stays = 0, hangs = 0;    ///< indices of the tree that stays and of the one that is hung on it
  /// The tree that is hung on, with the link; its node 0 lies on the tree that stays. Empty with an obstacle.
  VesselTree part;
  double link = 0.0;  ///< metres between both places
};
/// What a join would do.
/// @param at a place of the tree that stays. @param to a place of the tree that is to hang there. CT frame,
///   metres; the nearest nodes count.
/// @throws InputError no vessel within 20 mm of one of them.
Joining joining_at(const std::vector<VesselTree>& trees, const Eigen::Vector3d& at,
                   const Eigen::Vector3d& to);

/// The model with its trees as they were built, edited anew, one edit after the other; everything else stays.
/// Node 0 of a changed tree is its root.
/// @throws InputError naming the edit by its number: no vessel within 20 mm; join: two places of one tree
/// (that would close a loop), vessels of two kinds, or more than 60 mm apart.
BuiltModel with_tree_edits(const BuiltModel& built, std::vector<TreeEdit> edits);

/// JSON: {"frame": "LPS", "unit": "mm", "edits": [{"edit": "prune", "at": [x, y, z]}, {"edit": "join",
/// "at": [...], "to": [...]}]}. @throws FileError, InputError naming the field.
std::vector<TreeEdit> read_tree_edits(const std::filesystem::path& path);
/// @throws FileError.
void write_tree_edits(const std::filesystem::path& path, const std::vector<TreeEdit>& edits);

}  // namespace glisson::model
