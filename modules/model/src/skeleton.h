// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "glisson/volume/morphology.h"

namespace glisson::model {

struct SkeletonOptions {
  /// The weight of a voxel is 1 / r^exponent, r its distance from the boundary (paper: 4).
  double exponent = 4.0;
  /// The heap is keyed by the sum of weights from the root (Dijkstra) instead of the voxel's own weight (as
  /// the paper prints it). With the sum every stretch of a vessel that touches another is reached from there
  /// by a crossing of its own; with the own weight all of it follows from the first crossing.
  bool accumulated_cost = false;
  /// Of the second heuristic: a new path this near to perpendicular (radians) is never a false one.
  double right_angle_tolerance = 0.05;
  /// How far a branch must stand out of its parent's tube: millimetres, and over its own radius.
  double least_protrusion_mm = 4.0, least_protrusion_over_radius = 2.0;
  int most_orders = 16;
};

/// One branch: voxels from the fork (a voxel of the parent) to the tip.
struct SkeletonPath {
  std::vector<int> voxels;
  int parent = -1;           ///< path; -1: begins at the root
  int parent_position = -1;  ///< index into the parent's voxels
  int order = 0;
};

/// The voxels of a vessel and how far each lies from the vessel's boundary.
struct VesselVoxels {
  Mask mask;  ///< with a margin of one empty voxel on each side
  std::vector<float> radius_mm;

  Eigen::Vector3d position_mm(int voxel) const;  ///< spacing times index
  /// 26 neighbours' offsets and lengths (mm).
  struct Step {
    int offset;
    float length_mm;
  };
  std::vector<Step> steps() const;
};
/// @pre no voxel set on the mask's border.
VesselVoxels measure_vessel(Mask mask);

/// 26-connected pieces, largest first.
std::vector<std::vector<int>> vessel_pieces(const VesselVoxels& vessel);

/// The tree that spans everything reachable from the roots; several roots share the voxels out.
struct SpanningTree {
  std::vector<int> parent;       ///< of each voxel; -1: root or not reached
  std::vector<int> root_number;  ///< of each voxel; -1: not reached
  std::vector<float> from_root_mm;
  std::vector<int> order;  ///< voxels as they were reached: parents before children
};
SpanningTree span(const VesselVoxels& vessel, const std::vector<int>& roots, const SkeletonOptions& options);

/// Centrelines by order (paper 2.1.1, after Verscheure et al. 2013), both heuristics. One list of paths a
/// root; parents come before their children.
std::vector<std::vector<SkeletonPath>> skeleton(const VesselVoxels& vessel, const std::vector<int>& roots,
                                                const SkeletonOptions& options);

/// The voxel at the thickest end of a piece. @param favoured a weight a voxel (nullptr: all alike) that
/// multiplies an end's thickness: ends where the vessel may enter.
int thickest_end(const VesselVoxels& vessel, const std::vector<int>& piece, const SkeletonOptions& options,
                 const std::vector<float>* favoured);

}  // namespace glisson::model
