// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "glisson/geometry/camera.h"
#include "glisson/geometry/mesh.h"

namespace glisson::insilico {

/// What a ray met first.
struct RayHit {
  enum class Thing { nothing, organ, wall, tool };
  Thing thing = Thing::nothing;
  int triangle = -1;
  float parameter = 0.0F;                                 ///< origin + parameter * direction is the point met
  Eigen::Vector3f barycentric = Eigen::Vector3f::Zero();  ///< weights of the triangle's vertices
};

/// One ray a pixel, lens distortion undone, computed once a camera. Directions have unit depth in the
/// camera's own frame, so that a hit's parameter is its depth along the camera's z.
struct RayTable {
  int width = 0, height = 0;
  Eigen::Vector3f origin = Eigen::Vector3f::Zero();  ///< optical centre, left camera's frame, metres
  std::vector<Eigen::Vector3f> directions;           ///< left camera's frame; row-major
};
/// Of the left camera: the origin is zero.
RayTable left_rays(const StereoRig& rig);
/// Of the right camera, in the left one's frame. A hit's parameter is its depth along the right camera's z.
RayTable right_rays(const StereoRig& rig);

/// First hits on an organ that moves (its tree is refitted, not rebuilt), on a wall and on a tool, by
/// Embree. Any one frame, metres; single precision inside. Queries are const and thread-safe.
class RayCaster {
 public:
  /// @param organ closed; its first position gives the tree its shape. @pre triangles, indices in range.
  explicit RayCaster(const TriangleMesh& organ);
  ~RayCaster();
  RayCaster(RayCaster&&) noexcept;
  RayCaster& operator=(RayCaster&&) noexcept;

  /// @pre as many rows as the organ has vertices.
  void move_organ(const Points& vertices);
  /// Replaces the former wall. @pre it has triangles, indices in range. @throws NumericalError Embree.
  void set_wall(const TriangleMesh& wall);
  /// Likewise of a tool. Without triangles: there is none any more.
  void set_tool(const TriangleMesh& tool);

  /// The first hit in front of the origin, from either side of a surface. @param direction of any length; the
  /// hit's parameter counts in it. Where nothing is met: Thing::nothing, triangle -1.
  RayHit cast(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction) const;
  /// The same for `count` rays from one origin, eight at a time: neighbours in a picture's row.
  void cast(const Eigen::Vector3f& origin, const Eigen::Vector3f* directions, int count, RayHit* hits) const;
  /// Whether nothing lies between the two points (up to `slack` metres before `target`).
  bool sees(const Eigen::Vector3d& origin, const Eigen::Vector3d& target, double slack = 5e-4) const;
  /// Depth of the organ at every pixel, metres; 0 where the ray meets something else.
  std::vector<float> organ_depth(const RayTable& rays) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace glisson::insilico
