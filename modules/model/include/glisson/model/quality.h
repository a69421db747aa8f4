// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "glisson/patient/patient_model.h"

/// @file
/// What can be measured on a model as it stands, for a person who is to approve it. Nothing here needs the
/// labels or surfaces that the model was built from.

namespace glisson::model {

inline constexpr int kDihedralBins = 18;
/// How many of all dihedral angles (six a tetrahedron) lie in [0, 10), [10, 20) ... [170, 180] degrees.
std::array<int, kDihedralBins> dihedral_histogram(const TetMesh& mesh);

/// The tetrahedra with the smallest dihedral angles, the worst first; `count` of them at most.
std::vector<int> worst_tetrahedra(const TetMesh& mesh, int count);
/// The boundary of some of a mesh's tetrahedra, each by itself: four triangles a tetrahedron, normals
/// outwards.
TriangleMesh tetrahedra_as_surface(const TetMesh& mesh, const std::vector<int>& tetrahedra);

/// Metres; over all edges of a mesh, each counted once.
double mean_edge_length(const TetMesh& mesh);

/// A lesion in the model.
struct LesionVolume {
  Label label = 0;
  double volume = 0.0;       ///< m3, within its fine surface; 0: it has none
  double mesh_volume = 0.0;  ///< m3, of its tetrahedra; 0: it has none, and follows the tissue around it
  double diameter = 0.0;     ///< m, of the ball of the same volume
};
/// By label, ascending.
std::vector<LesionVolume> lesion_volumes(const PatientModel& model);

/// One tree of vessels.
struct TreeSummary {
  Label structure = 0;
  int beams = 0, forks = 0, tips = 0;              ///< tips without the root
  double length = 0.0;                             ///< m
  double root_radius = 0.0;                        ///< m, of the entrance
  Eigen::Vector3d root = Eigen::Vector3d::Zero();  ///< CT frame, metres
};
TreeSummary tree_summary(const VesselTree& tree);
/// In the order of PatientModel::vessels.
std::vector<TreeSummary> tree_summaries(const PatientModel& model);

}  // namespace glisson::model
