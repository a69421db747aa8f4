// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "glisson/atlas/atlas.h"
#include "glisson/core/run_context.h"
#include "glisson/experiments/paper_figure.h"

/// @file
/// The paper's Fig. 5: an atlas of ten livers laid on each of them (foretold by the others) and on livers
/// that are not among them. How far are surface, umbilical notch and vena cava from where they are?

namespace glisson::experiments {

/// On which livers an atlas is tried.
struct TransferStudyOptions {
  std::filesystem::path data;  ///< with liver_labelmaps and liver_models; absent: in silico only
  std::shared_ptr<const atlas::Atlas> base;  ///< the atlases' template
  int livers = 10;                           ///< synthetic ones in the atlas; five at least
  int outside = 2;                           ///< synthetic ones that are not
  std::uint64_t seed = 1;                    ///< which
  /// Few livers, none of them real: to see whether it runs.
  static TransferStudyOptions quick();
  /// @throws InputError naming the option.
  void validate() const;
};

/// One liver. Metres; not a number: its truth is not known.
struct TransferRow {
  std::string liver;
  bool real = false;
  bool outside = false;  ///< of the atlas; else foretold by its other livers
  /// "Mean Hausdorff distance" of surfaces: from samples of one to the closest point of the other, mean; the
  /// worse direction. `surface_largest`: the largest of these distances.
  double surface = 0.0, surface_largest = 0.0;
  double notch = 0.0;  ///< from the true point to the one foretold; known in silico only
  /// Of the vena cava's contacts: from each point to the closest of the other contact, mean; half the sum of
  /// both directions. `cava_largest`: their Hausdorff distance.
  double cava = 0.0, cava_largest = 0.0;
};

/// How far off surface, notch and vena cava were foretold, liver by liver.
struct TransferStudy {
  std::vector<TransferRow> rows;
  /// How the atlas' livers differ in where notch and cava lie on the mean liver
  /// (atlas::BuildResult::spreads), metres; not a number: unknown. The cava's middle counts.
  double notch_spread = 0.0, cava_spread = 0.0, real_cava_spread = 0.0;
  std::vector<std::string> absent;
};

/// A row of what was foretold of a liver.
TransferRow row_of(const atlas::LeftOut& foretold, bool real, bool outside);

/// Synthetic livers, then the label maps of even numbers (the others are for validation) and, outside of
/// these, the liver of `liver_models`, which shows neither notch nor cava. Minutes. Empty: cancelled.
/// @throws InputError options; Error of any stage.
Cancellable<TransferStudy> study_transfer(const TransferStudyOptions& options, const RunContext& context);

/// The figure's tables and figures, without its command.
PaperFigure figure_of(const TransferStudy& study);

}  // namespace glisson::experiments
