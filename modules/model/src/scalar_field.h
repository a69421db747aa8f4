// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "glisson/geometry/mesh.h"
#include "glisson/volume/grid.h"
#include "glisson/volume/morphology.h"

namespace glisson::model {

/// A smooth function of space whose zero level is the boundary of a body: positive inside. Sampled on a grid
/// around the body, trilinear between the samples. What the mesher and the isosurfaces share.
class ScalarField {
 public:
  ScalarField() = default;
  /// @param values i fastest. @pre as many as voxels.
  ScalarField(const VolumeGrid& grid, std::vector<float> values);

  /// At a point of the CT frame (metres). Outside the grid: negative.
  double at(const Eigen::Vector3d& p_in_ct) const;
  const VolumeGrid& grid() const { return grid_; }
  const std::vector<float>& values() const { return values_; }
  bool empty() const { return values_.empty(); }

  /// Corners of the axis-parallel box (CT, metres) around the samples that are inside.
  Eigen::Vector3d low() const { return low_; }
  Eigen::Vector3d high() const { return high_; }
  /// Cubic metres inside, counted by voxels with their fraction.
  double volume() const;
  /// Where it is largest (CT, metres): the point that lies deepest.
  Eigen::Vector3d deepest() const;

 private:
  VolumeGrid grid_;
  std::vector<float> values_;
  Eigen::Matrix3d index_from_ct_;  ///< of metres
  Eigen::Vector3d offset_;
  Eigen::Vector3d low_, high_;
};

/// A mask of voxels as a field whose zero level is smooth and encloses the mask's volume: a Gaussian takes
/// the stairs away, and the level is chosen so that nothing shrinks.
/// @param smoothing_mm standard deviation.
ScalarField field_of_mask(const VolumeGrid& grid, const std::vector<std::uint8_t>& mask, double smoothing_mm);
/// The same, to the bit, of a part of the grid that holds all of it. @param low the part's first voxel.
ScalarField field_of_mask(const VolumeGrid& grid, const Mask& mask, const Eigen::Vector3i& low,
                          double smoothing_mm);

/// Signed distance (millimetres) to a closed surface, exact within two voxels of it.
/// @pre is_closed(surface)
ScalarField field_of_surface(const TriangleMesh& surface, double spacing_mm);

/// The field on a grid along the axes of the CT.
ScalarField resampled(const ScalarField& field, double spacing_mm);

/// An axis-parallel grid around points, with a margin.
VolumeGrid grid_around(const Points& points, double spacing_mm, double margin_mm);

/// Voxels whose centre lies inside a closed surface (winding number along rows). @pre the grid's axes are the
/// CT's.
std::vector<std::uint8_t> voxelise(const TriangleMesh& surface, const VolumeGrid& grid);

/// The zero level as a closed triangle mesh, normals outwards, CT frame, metres (flying edges, Schroeder
/// 2015).
TriangleMesh zero_level(const ScalarField& field);

}  // namespace glisson::model
