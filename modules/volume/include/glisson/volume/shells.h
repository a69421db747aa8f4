// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "glisson/volume/label_volume.h"
#include "glisson/volume/morphology.h"

namespace glisson {

/// A tree of voxels cut into shells: pieces of equal distance from the root, measured inside the tree. A
/// piece is a cross-section of a branch, about as thick as `thickness_mm`; pieces and their neighbours
/// towards the root make a graph with the tree's branches (a Reeb graph of the distance).
struct Shells {
  /// A cross-section of a branch; connected through 26 neighbours.
  struct Piece {
    int parent = -1;           ///< towards the root; -1 at the root
    double area_mm2 = 0.0;     ///< volume over thickness
    double distance_mm = 0.0;  ///< of its nearest voxel from the root
    double volume_mm3 = 0.0;
    Eigen::Vector3d centre{0, 0, 0};  ///< mean index in the volume
    int height = 0;                   ///< pieces on the longest way outwards
    std::vector<int> children;
  };
  VoxelBox box;               ///< of the tree in its volume
  Mask grid;                  ///< the box's extent; voxels: the tree
  std::vector<int> piece;     ///< of each voxel of the box; -1: none
  std::vector<Piece> pieces;  ///< parents before children
  int loops = 0;              ///< how often two branches meet again
  double thickness_mm = 0.0;

  /// The piece itself and all that hangs on it.
  std::vector<int> beyond(int from) const;
  /// Children on which at least two more pieces hang: the others are bumps of the wall.
  std::vector<int> branches_of(int from) const;
};

/// Shells of the part of `tree` that is joined (26 neighbours) to the root.
/// @param root index in the volume; none: the tree's thickest place. The voxel of the tree nearest to it
///   counts.
/// @return no pieces when nothing is set.
Shells shells_of(const VolumeGrid& grid, const std::vector<std::uint8_t>& tree,
                 const std::optional<Eigen::Vector3d>& root);

/// Shells of every part of a tree that holds at least so much, each from its own thickest place; the largest
/// first.
std::vector<Shells> shells_of_each(const VolumeGrid& grid, const std::vector<std::uint8_t>& tree,
                                   double least_mm3);

/// Patches joined through 26 neighbours, as lists of voxels.
std::vector<std::vector<std::size_t>> patches_of(const Mask& mask);

/// The set voxel nearest to an index, within `reach_mm`.
std::optional<Eigen::Vector3i> nearest_set(const VolumeGrid& grid, const std::vector<std::uint8_t>& mask,
                                           const Eigen::Vector3d& index, double reach_mm);

}  // namespace glisson
