// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "glisson/core/json_file.h"
#include "glisson/core/run_context.h"
#include "glisson/geometry/camera.h"
#include "glisson/stereo/board.h"

namespace glisson::stereo {

/// Which unknowns a calibration has, and which views it believes.
struct CalibrateOptions {
  bool third_radial = false;           ///< k3 too; without many corners near the borders it is noise
  bool leave_one_out = true;           ///< calibrate again without each view (5 views and more)
  bool drop_outliers = false;          ///< leave out what is proposed, and calibrate again
  std::vector<std::string> without;    ///< names of views that are left out from the beginning
  std::optional<StereoRig> reference;  ///< another calibration of the same scope, to compare with

  /// @throws InputError naming the option: a view without a name, a reference that is no laparoscope's.
  void validate() const;
};

/// How well one view fits. Errors in pixels of the pictures as taken; NaN: not computed.
struct ViewReport {
  std::string name;
  bool used = true;        ///< false: dropped as an outlier, or left out as told
  bool outlier = false;    ///< proposed for removal: fits far worse than the others
  double left_rms = 0.0;   ///< of the corners, reprojected; of a view dropped: by the calibration before
  double right_rms = 0.0;  ///< the same
  double distance = 0.0;   ///< metres to the board's middle, left camera
  double tilt = 0.0;       ///< radians between the board's normal and the view
  /// rms of the difference of rows after rectification, of this view's corners, by a calibration that has
  /// not seen it; and by the reference.
  double epipolar_left_out = 0.0, epipolar_reference = 0.0;
};

/// A laparoscope's two cameras, and how well they are known.
struct Calibration {
  StereoRig rig;
  double rms = 0.0;                            ///< joint stereo, over all corners of both pictures, pixels
  double left_rms = 0.0, right_rms = 0.0;      ///< of each camera
  double left_alone = 0.0, right_alone = 0.0;  ///< of each camera calibrated without the other
  double focal_sigma = 0.0;                    ///< standard deviation of the left focal length, pixels
  double left_coverage = 0.0, right_coverage = 0.0;  ///< share of the picture within a board's outline
  double epipolar_rms = 0.0;                         ///< of the rectified rows, all views used, pixels
  double epipolar_left_out = 0.0;   ///< rms over the views, each left out in turn; NaN: not computed
  double epipolar_reference = 0.0;  ///< rms over the same corners by the reference; NaN: none was given
  std::vector<ViewReport> views;    ///< as the BoardViews' order
};

/// Both cameras and their pose together, from the views of a board: Zhang's method for each camera, then all
/// unknowns jointly by Levenberg-Marquardt (OpenCV's stereoCalibrate, intrinsics free).
/// @throws InputError options; fewer than 3 views with a board (a wrong board size is recognised) or without
///   those left out; left and right swapped; a baseline that no laparoscope has (the squares' size is wrong);
///   all views parallel; cameras that read_calibration() would refuse.
Cancellable<Calibration> calibrate(const BoardViews& views, const CalibrateOptions& options,
                                   const RunContext& context);

/// What a calibration is judged by, keys "calibration_...", units in the names. NaN: not computed.
Figures calibration_figures(const Calibration& calibration);

/// rms of the difference of rows after rectification, pixels: how far corners lie from their epipolar lines.
double epipolar_rms(const StereoRig& rig, const BoardView& view);

/// Width of either picture in coverage_picture, and what lies between the two, pixels.
inline constexpr int kCoverageWidth = 640, kCoverageGap = 8;
/// Both pictures side by side, grey, with every corner used (outliers apart) and each board's outline: what
/// no board has covered is extrapolated. Three channels.
Picture coverage_picture(const BoardViews& views, const Calibration& calibration);

}  // namespace glisson::stereo
