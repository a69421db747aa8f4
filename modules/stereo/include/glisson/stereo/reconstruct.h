// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "glisson/core/codes.h"
#include "glisson/patient/labelled_cloud.h"

/// @file
/// How the points of a stereo pair are asked for, and what is told of them. The door: reconstruct_pair.h.

namespace glisson::stereo {

/// How points are found in a pair.
enum class Method {
  sparse,    ///< the paper's: features, matched
  dense,     ///< semi-global matching, sampled: covers what lies between features
  automatic  ///< sparse; dense where that is thinner than `least_density_per_cm2`, and dense is denser
};
/// SURF is the paper's. All go the same way afterwards.
enum class Features { surf, sift, akaze };

/// For files and the command line.
inline constexpr Codes<Method, 3> kMethodCodes = {
    {{"sparse", Method::sparse}, {"dense", Method::dense}, {"automatic", Method::automatic}}};
inline constexpr Codes<Features, 3> kFeatureCodes = {
    {{"surf", Features::surf}, {"sift", Features::sift}, {"akaze", Features::akaze}}};

/// Which points are made of a pair, and which are believed.
struct ReconstructOptions {
  Method method = Method::sparse;
  Features kind = Features::surf;
  int features = 3000;                 ///< sparse: wanted per image, spread over it
  double ratio = 0.8;                  ///< Lowe's, in (0, 1]
  double epipolar_px = 1.5;            ///< after refinement, rectified rows less their common offset
  double reprojection_px = 1.0;        ///< in both images as they were taken
  double near = 0.03;                  ///< metres along z, what lies closer is no match
  double far = 0.30;                   ///< metres along z
  double points_per_cm2 = 8.0;         ///< dense: wanted density
  int patch = 10;                      ///< half width of the patches that refine a match, pixels
  bool smooth = true;                  ///< moving least squares
  double least_density_per_cm2 = 0.7;  ///< automatic: the paper's need
  bool find_circle = true;  ///< without a mask: leave out what lies outside the laparoscope's circle
  /// @throws PreconditionError naming what is out of range.
  void validate() const;
  bool operator==(const ReconstructOptions&) const = default;
};

/// What became of a pair. Lengths as the names say, else metres.
struct ReconstructReport {
  Method method = Method::sparse;  ///< that made the points
  int features_left = 0, features_right = 0;
  int matches = 0;  ///< before refinement and gates
  int points = 0;
  double area_cm2 = 0.0;         ///< of the surface that the points stand for (within the mask)
  double density_per_cm2 = 0.0;  ///< points / area
  /// Median by which rectified right rows exceed left ones: the calibration's error.
  double row_offset_px = 0.0;
  double epipolar_rms_px = 0.0;  ///< of the points kept: what calibration and refinement leave
  double sigma_median = 0.0;     ///< metres, along the ray
  /// How far points lie off their neighbours' surface over what noise lets expect (1: as expected). Where it
  /// is more than 1, cloud.sigma and the covariances are raised by it.
  double misfit = 1.0;
};

/// The points of a whole pair.
struct Reconstructed {
  LabelledCloud cloud;  ///< left camera's frame, metres, with normals and sigma; all surface
  /// Of each point as triangulated (before moving least squares, which lowers the part along the ray to
  /// cloud.sigma), metres^2, left camera: from what the refinement and the rows leave, in first order.
  std::vector<Eigen::Matrix3d> covariance;
  ReconstructReport report;
};

}  // namespace glisson::stereo
