// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>

#include "glisson/engine/command.h"
#include "glisson/stereo/board_series.h"
#include "glisson/stereo/calibrate.h"

namespace glisson::engine {

/// How a calibration was made and how far to trust it.
struct CalibrationSheet {
  std::shared_ptr<const stereo::BoardViews> views;
  stereo::Calibration calibration;
  Picture coverage;  ///< stereo::coverage_picture
};

/// Calibrates the laparoscope from pictures of a board. Outliers are notes: "calibration.outlier NAME" was
/// dropped, "calibration.proposed NAME" was not.
struct CalibrateRig {
  using Result = CalibrationSheet;
  stereo::BoardSearch search;
  stereo::CalibrateOptions options;
  /// Another calibration of the same scope (stereo::read_calibration_for), read into options.reference once
  /// the pictures' size is known; empty: none.
  std::filesystem::path reference = {};
  /// The boards, where an earlier outcome has them: they are not looked for.
  std::shared_ptr<const stereo::BoardViews> found = {};
  /// Called while the boards are looked for, where the command is done.
  stereo::BoardTold told = {};

  CommandTraits traits() const;
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
