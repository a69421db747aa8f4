// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "glisson/core/json_file.h"
#include "glisson/core/run_context.h"

/// @file
/// How well an organ is followed before a scope in a slow and in a fast hand, while a tool takes it along,
/// and over thousands of frames: in the theatre, from a right start.

namespace glisson::experiments {

/// What is filmed and followed.
struct FollowingProofOptions {
  std::uint64_t seed = 101;  ///< of patient, theatre and tools
  int frames = 240;          ///< of each film but the long one, 30 a second
  int long_frames = 3000;
  std::string only;  ///< films whose name contains this; empty: all
  /// @throws InputError naming the option.
  void validate() const;
};

/// How far off it was.
struct FollowingProof {
  Figures figures;                 ///< keys begin with "following_"
  std::vector<std::string> table;  ///< a line each film, the first its heads
};

/// An error is a mean over the nodes of the model. An organ's motion is that since the first frame with the
/// scope's motion taken out: the error of a model that goes with the scope as it truly moves, and stays
/// otherwise. Leaves `following.csv`, a line each frame, in `folder`, which exists. Empty: cancelled.
/// @throws Error.
Cancellable<FollowingProof> prove_following(const FollowingProofOptions& options,
                                            const std::filesystem::path& folder, const RunContext& context);

}  // namespace glisson::experiments
