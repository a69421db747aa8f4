// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "glisson/core/json_file.h"
#include "glisson/core/run_context.h"
#include "glisson/experiments/aims.h"

/// @file
/// From the laparoscope's pictures to clouds, measured: on real pairs (CT surface, chessboards, a heart) and
/// in the theatre, whose depth is known.

namespace glisson::experiments {

/// What is measured.
struct StereoProofOptions {
  /// The folder with stereo_opencas, stereo_chessboard and stereo_heart; what is absent is left out.
  std::filesystem::path data;
  bool theatre = true;
  std::string only;  ///< of the theatre's trials those whose name contains this; empty: all
  std::uint64_t seed = 1;
};

/// What was measured, from pictures to clouds.
struct StereoProof {
  /// Keys begin with "opencas_", "chessboard_", "heart_" (real) or "theatre_" (in silico).
  Figures figures;
  std::vector<std::string> absent;  ///< sets of real data that were left out
  std::vector<std::string> table;   ///< the theatre's, a line each, the first its heads
};

/// What prove_stereo() is measured against.
const std::vector<Aim>& stereo_aims();

/// Leaves pictures of the error, of the density and of the calibration's coverage, and the theatre's table as
/// CSV, in `folder`, which exists. The truth is read after everything else. Empty: cancelled. @throws Error.
Cancellable<StereoProof> prove_stereo(const StereoProofOptions& options, const std::filesystem::path& folder,
                                      const RunContext& context);

}  // namespace glisson::experiments
