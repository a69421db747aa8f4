// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "glisson/geometry/camera.h"
#include "glisson/patient/picture.h"

/// Stereo pairs of known depth, ray by ray: independent of the theatre and of the module under test.
namespace rendered {

/// Parameter t of the first point o + t d on the surface; 0: missed.
using Surface = std::function<double(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction)>;

Surface plane(const Eigen::Vector3d& point, const Eigen::Vector3d& normal);

Surface sphere(const Eigen::Vector3d& centre, double radius);

/// The nearer of two.
Surface both(const Surface& one, const Surface& other);

/// Distorted, slightly toed in and rolled, as real ones are.
glisson::StereoRig rig();

/// Smooth noise in space, bound to the tissue, in [-1, 1].
double noise(const Eigen::Vector3d& p);

struct Look {
  double grain = 0.0015;   ///< metres of the coarsest texture
  double contrast = 35.0;  ///< grey levels
  double sensor = 1.5;     ///< standard deviation of the noise, grey levels
};

/// What one camera sees of the surface. @param depth along each pixel's ray, metres, 0 where it is missed;
/// null: not asked for.
glisson::Picture render(const glisson::StereoRig& rig, bool is_left, const Surface& surface, const Look& look,
                        std::vector<float>* depth);

struct Pair {
  glisson::StereoRig rig;
  glisson::Picture left, right;
  std::vector<float> depth;  ///< of the left pixels' centres, metres
};

Pair pair(const Surface& surface, const Look& look = {});

}  // namespace rendered
