// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "glisson/geometry/camera.h"
#include "glisson/geometry/mesh.h"
#include "glisson/insilico/ray_caster.h"
#include "glisson/patient/picture.h"
#include "tissue_look.h"

namespace glisson::insilico {

using FloatPoints = Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// A surface as the painter needs it: where it is now, where its material was at rest.
struct PaintedSurface {
  Triangles triangles;
  FloatPoints rest_mm;                                             ///< texture coordinates
  FloatPoints moved;                                               ///< left camera's frame, metres
  FloatPoints normals;                                             ///< a vertex, unit, left camera's frame
  Eigen::Matrix3f camera_from_rest = Eigen::Matrix3f::Identity();  ///< mean rotation, turns the bumps
};

/// What may be met.
struct PaintedScene {
  PaintedSurface liver, wall, tool;
};

/// Paints what the ray caster meets: diffuse and glossy tissue, a light at the laparoscope's tip with inverse
/// square fall-off and a soft cone, vignetting, a lens that is not quite sharp, exposure fixed once, film
/// curve and gamma, sensor noise by frame.
class Painter {
 public:
  Painter(const StereoRig& rig, std::uint64_t seed, double noise_levels, double reference_distance);

  enum class Eye { left, right };
  /// Linear light, red green blue, row-major.
  std::vector<float> light(Eye eye, const RayCaster& caster, const PaintedScene& scene) const;
  /// Sets the exposure so that the liver's median in the left picture is well exposed.
  void expose(const RayCaster& caster, const PaintedScene& scene);
  /// @param frame seeds the noise.
  Picture picture(Eye eye, int frame, const RayCaster& caster, const PaintedScene& scene) const;
  const RayTable& rays(Eye eye) const { return eye == Eye::left ? left_ : right_; }

 private:
  struct Row;
  void meet(Eye eye, int y, const RayCaster& caster, const PaintedScene& scene, Row& row) const;
  Eigen::Array3f shade(const Eigen::Vector3f& p, const Eigen::Vector3f& normal, const Eigen::Vector3f& to_eye,
                       const Look& look, const Eigen::Vector3f& lean) const;

  RayTable left_, right_;
  Tissue tissue_;
  Eigen::Vector3f lamp_;
  Eigen::Vector3f left_axis_ = Eigen::Vector3f::UnitZ(), right_axis_;
  float focal_left_, focal_right_;
  float reference_;  ///< distance at which the lamp gives one
  float exposure_ = 1.0F;
  std::vector<float> film_;  ///< light to grey level
  std::vector<float> gauss_;
  std::uint64_t seed_;
};

}  // namespace glisson::insilico
