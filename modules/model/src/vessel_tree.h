// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "bezier.h"
#include "glisson/patient/patient_model.h"
#include "skeleton.h"

namespace glisson::model {

/// One tree of voxel paths, its curves fitted: what beams are sampled from.
class FittedTree {
 public:
  /// @param grid where the vessel's voxels lie. @param paths of one root, parents first.
  FittedTree(const VesselVoxels& vessel, const VolumeGrid& grid, const std::vector<SkeletonPath>& paths,
             Label structure);

  struct Sampling {
    double longest_mm = 10.0;  ///< beam where the vessel is straight
    double shortest_mm = 2.0;  ///< forks nearer than this share a node
    double turn = 0.35;        ///< radians that one beam may span of a bend
  };
  /// Nodes and beams; node 0 is the root. Denser where the vessel bends; a node at each fork.
  VesselTree sample(const Sampling& sampling) const;

  int branch_count() const { return static_cast<int>(branches_.size()); }
  /// A branch that bears no other.
  struct Leaf {
    int branch = -1;  ///< none: only the trunk is left
    double radius_mm = 0.0, length_mm = 0.0;
    /// Whether it goes first: the thinner one, of two about as thin (a quarter of a millimetre) the shorter.
    bool before(const Leaf& other) const;
  };
  Leaf next_to_prune() const;
  /// @pre `leaf` is of this tree as it is.
  void prune(const Leaf& leaf);
  double length_mm() const;
  /// Largest distance between the curves and the smoothed paths that they were fitted to, either way; at most
  /// tolerance_mm().
  double curve_error_mm() const;
  double tolerance_mm() const { return tolerance_mm_; }

 private:
  struct Branch {
    int parent = -1;
    double parent_station = 0.0;          ///< arc length (mm) on the parent
    std::vector<double> voxel_stations;   ///< arc length of each voxel of the path, mm
    std::vector<double> stations;         ///< arc length of the dense samples, mm
    std::vector<Eigen::Vector3d> points;  ///< dense samples, mm in the vessel's own axes
    std::vector<double> curvature;        ///< 1/mm
    std::vector<double> radius;           ///< mm
    double mean_radius = 0.0;
    double curve_error = 0.0;  ///< mm
    double length() const { return stations.back(); }
  };
  Branch fit(const VesselVoxels& vessel, const SkeletonPath& path) const;
  static void measure_radius(const VesselVoxels& vessel, const SkeletonPath& path, Branch& branch);
  static void measure_curvature(Branch& branch);
  /// Where nodes must stand on a branch: its ends and the forks of its children, near ones joined.
  std::vector<double> fixed_stations(std::size_t branch, double shortest_mm) const;

  VolumeGrid grid_;
  Label structure_;
  double tolerance_mm_ = 0.0;
  std::vector<Branch> branches_;
};

}  // namespace glisson::model
