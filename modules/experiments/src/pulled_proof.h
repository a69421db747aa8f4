// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "glisson/core/json_file.h"
#include "glisson/core/run_context.h"
#include "glisson/experiments/aims.h"

/// @file
/// Bare organs that are held somewhere and pulled or pressed at a few places, as those of Mestdagh and Cotin
/// (2022): how far off registration and following are where neither anatomy nor operations are known.

namespace glisson::experiments {

/// What is measured.
struct PulledProofOptions {
  std::filesystem::path data;  ///< for elastic_sequence; absent: left out
  std::uint64_t seed = 1;
  int organs = 4;    ///< of each kind, each with and without noise
  int frames = 6;    ///< that each is followed over, the registered one included
  int nodes = 2500;  ///< of an organ that is not elastic_sequence's: about as many as that has
  int threads = 2;
  /// Few organs: to see whether it runs.
  static PulledProofOptions quick();
  /// @throws InputError naming the option.
  void validate() const;
};

/// What was measured of bare organs: registered once, then followed.
struct PulledProof {
  Figures figures;  ///< keys begin with "pulled_" or "sequence_"
  std::vector<std::string> table;
  std::vector<std::string> absent;  ///< data that were not there
};

/// Errors are means over all nodes. Keeps `pulled_SEED.csv`, a line an organ, in `folder`, which exists.
/// Empty: cancelled. @throws Error.
Cancellable<PulledProof> prove_pulled(const PulledProofOptions& options, const std::filesystem::path& folder,
                                      const RunContext& context);

/// What its figures should be.
const std::vector<Aim>& pulled_aims();

}  // namespace glisson::experiments
