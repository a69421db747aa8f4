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

/// The trees after the edits, one after the other. Node 0 of a changed tree is its root.
/// @throws InputError naming the edit by its number: no vessel within 20 mm; join: two places of one tree
/// (that would close a loop), vessels of two kinds, or more than 60 mm apart.
std::vector<VesselTree> edited_trees(std::vector<VesselTree> trees, const std::vector<TreeEdit>& edits);

/// The model with its trees as they were built, edited anew; everything else stays.
/// @throws InputError as edited_trees().
BuiltModel with_tree_edits(const BuiltModel& built, std::vector<TreeEdit> edits);

/// JSON: {"frame": "LPS", "unit": "mm", "edits": [{"edit": "prune", "at": [x, y, z]}, {"edit": "join",
/// "at": [...], "to": [...]}]}. @throws FileError, InputError naming the field.
std::vector<TreeEdit> read_tree_edits(const std::filesystem::path& path);
/// @throws FileError.
void write_tree_edits(const std::filesystem::path& path, const std::vector<TreeEdit>& edits);

}  // namespace glisson::model
