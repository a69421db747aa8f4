// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "glisson/core/json_file.h"
#include "glisson/core/run_context.h"
#include "glisson/experiments/aims.h"

/// @file
/// What the live overlay says of itself when something is wrong, measured where the truth is known: in the
/// theatre, and on real tissue that is set in motion. Wrong starts, and faults put into the frames.

namespace glisson::experiments {

/// What is measured.
struct LiveProofOptions {
  /// Patients and theatres. See told_of_patients().
  std::vector<std::uint64_t> seeds{15, 16};
  int frames = 120;  ///< of each run, 30 a second
  int onset = 30;    ///< frame from which a fault of the frames is there
  /// The folder with stereo_opencas (liver tissue before a real laparoscope; for development) and
  /// stereo_heart (silicone; for validation); what is absent is left out.
  std::filesystem::path data;
  std::string only;  ///< runs whose name contains this; empty: all
  /// @throws InputError naming the option.
  void validate() const;
};

/// Whether the overlay withdraws itself when it is wrong, and only then.
struct LiveProof {
  /// Over all runs: share of the frames truly over 10 mm that are not valid, of those under 3 mm that are
  /// valid (of all, and of those without a fault), seconds to the withdrawal, milliseconds of a frame. Keys
  /// begin with "live_", those of real pairs with "live_tissue_" and
  /// "live_heart_".
  Figures figures;
  std::vector<std::string> absent;  ///< sets of real data that were left out, and faults that nothing showed
  std::vector<std::string> table;   ///< a line each fault, the first its heads
};

/// Leaves `live.csv`, a line each frame with its error and evidence, `live.txt`, the table, and pictures
/// of the moved tissue in `folder`, which exists. A frame's error is the largest over the lesions' centres.
/// Empty: cancelled. @throws Error.
Cancellable<LiveProof> prove_live(const LiveProofOptions& options, const std::filesystem::path& folder,
                                  const RunContext& context);

/// A sentence on whether limits of guidance::JudgeOptions were set on the theatre's patients of these seeds.
/// Empty: there are none.
std::string told_of_patients(const std::vector<std::uint64_t>& seeds);

/// What its figures should be.
const std::vector<Aim>& live_aims();

}  // namespace glisson::experiments
