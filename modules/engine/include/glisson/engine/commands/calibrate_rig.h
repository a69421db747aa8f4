// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>

#include "glisson/engine/command.h"
#include "glisson/stereo/calibrate.h"

namespace glisson::engine {

/// How a calibration was made and how far to trust it.
struct CalibrationSheet {
  std::shared_ptr<const stereo::BoardViews> views;
  stereo::Calibration calibration;
  Picture coverage;  ///< stereo::coverage_picture
};

/// Calibrates the laparoscope from pairs of pictures of a board (stereo::picture_pairs: a folder; or with
/// `right` two folders or patterns). Outliers are notes: "calibration.outlier NAME" was dropped,
/// "calibration.proposed NAME" was not.
struct CalibrateRig {
  using Result = CalibrationSheet;
  std::filesystem::path left, right;
  stereo::Board board;
  stereo::CalibrateOptions options;
  /// The boards, where an earlier outcome or the caller (from a video) has them: they are not looked for.
  std::shared_ptr<const stereo::BoardViews> found = {};

  CommandTraits traits() const;
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
