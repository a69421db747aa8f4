// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "glisson/geometry/camera.h"
#include "glisson/patient/picture.h"

namespace glisson::guidance {

/// What stereo sees along one ray.
struct SeenPoint {
  int column = 0, row = 0;                                ///< of the grid
  Eigen::Vector3d p_in_camera = Eigen::Vector3d::Zero();  ///< left camera's frame, metres
  double sigma = 0.0;                                     ///< metres along the ray
};

/// A coarse surface from one pair, quickly: semi-global matching (Hirschmüller 2008, by OpenCV) of the pair
/// rectified at a reduced size, read on a grid. What it puts there is taken where the two pictures confirm it
/// (fit_disparity()): dark, plain tissue is seen whole, which block matching alone sees in scraps, and what
/// smoothness has made up is not. It knows nothing of any model or of former frames. Not thread-safe.
class SmallStereo {
 public:
  /// Metres along z between which a laparoscope sees an organ.
  static constexpr double kNear = 0.04, kFar = 0.30;

  /// @param width of the reduced pictures, pixels. @param step of the grid, in those pixels.
  /// @param near, far metres along z.
  SmallStereo(const StereoRig& rig, int width, int step, double near, double far);
  ~SmallStereo();

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  /// The left camera's ray through a place of the grid, unit, left camera's frame; and its pixel there.
  const Eigen::Vector3d& ray(int column, int row) const;
  const Eigen::Vector2d& pixel(int column, int row) const;
  /// The grid's place (column, row) in which a point lies, left camera's frame; empty: outside.
  std::optional<std::pair<int, int>> place(const Eigen::Vector3d& p_in_camera) const;

  /// Only what passes the checks of matching (uniqueness, left against right) and is confirmed.
  /// @throws InputError pictures of another size than the calibration's.
  std::vector<SeenPoint> see(const Picture& left, const Picture& right);

 private:
  struct Impl;
  StereoRig rig_;
  int columns_ = 0, rows_ = 0, step_ = 1;
  std::vector<Eigen::Vector3d> rays_;
  std::vector<Eigen::Vector2d> pixels_;
  std::unique_ptr<Impl> impl_;
};

}  // namespace glisson::guidance
