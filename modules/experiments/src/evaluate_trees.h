// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "glisson/patient/patient_model.h"

/// @file
/// Vessel trees against those of a patient whose truth is known. For final comparisons only.

namespace glisson::experiments {

/// How the trees that were found of a structure agree with the true one. Lengths in metres.
struct TreeScore {
  /// Distance of the found nodes from the true lines; not a number where nothing was found.
  double mean = 0.0, worst = 0.0;
  int thick = 0, thick_found = 0;  ///< true branches of 2 mm mean radius and more; 80 % of their line found
  /// Found beams between places that are far apart along the true tree (20 mm more than their length): false
  /// loops, were they not cut open into a tree.
  int bridges = 0;
  int doubled = 0;  ///< found nodes within a voxel of others of the same tree that are far along it
};

/// @param found trees of any structures; those of the truth's count.
/// @param voxel edge of a voxel, metres: what is nearer to the true line is found.
/// @param in_labels whether a point of a true line (CT, metres) is to be found at all: not what runs outside.
TreeScore score_tree(const VesselTree& truth, const std::vector<VesselTree>& found, double voxel,
                     const std::function<bool(const Eigen::Vector3d&)>& in_labels);

}  // namespace glisson::experiments
