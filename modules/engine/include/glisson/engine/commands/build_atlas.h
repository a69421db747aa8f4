// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "glisson/atlas/atlas.h"
#include "glisson/engine/command.h"

namespace glisson::engine {

/// Builds an atlas of cases and keeps it as a folder. Changes no part.
struct BuildAtlas {
  using Result = atlas::BuildResult;
  /// Cases with a model, and folders that hold such cases.
  std::vector<std::filesystem::path> cases = {};
  std::shared_ptr<const atlas::Atlas> base = nullptr;  ///< see atlas::build
  atlas::BuildOptions options = {};
  /// Folder for the atlas; one that is there is replaced in one step (see atlas::replace_atlas): after a kill
  /// there is the former atlas or the new one, whole. Empty: nothing is written.
  std::filesystem::path out = {};
  std::vector<atlas::Member> members = {};  ///< livers beside the cases
  /// Cases in which nobody has approved what the atlas reads (liver, vena cava, gallbladder, portal vein) are
  /// taken, too; else they are left out, which the note "atlas.not_approved NAME" says. A model that came
  /// without labels has nothing to approve.
  bool unapproved = false;

  CommandTraits traits() const;
  /// @pre a base
  /// @throws InputError a folder without a case, a case without a model, two of one name, fewer than five
  ///   livers, no structure is known of any, `out` is a folder of something else; FileError, also where `out`
  ///   cannot be written, which is found before the work.
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
