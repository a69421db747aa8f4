// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "glisson/geometry/mesh.h"
#include "glisson/geometry/topology.h"
#include "glisson/volume/label_volume.h"

namespace glisson {

/// Centrelines of one vessel tree, sampled to the 6-DoF nodes of its beams. CT frame, metres.
struct VesselTree {
  Label structure = 0;  ///< structure::kPortalVein, kHepaticVeins or kArtery
  PointsIn<CtFrame> nodes;
  std::vector<double> radii;              ///< outer radius at each node, metres
  std::vector<std::array<int, 2>> beams;  ///< node indices, from the root outwards
  int root = -1;                          ///< the entrance: where the tree comes into the liver
};

/// A structure's surface for drawing and measuring. CT frame, metres.
struct NamedSurface {
  Label structure = 0;
  std::string name;
  TriangleMesh mesh;
};

/// Anatomical landmarks on the liver. CT frame, metres. Empty members are unknown, not at the origin.
struct Landmarks {
  PointsIn<CtFrame> anterior_margin;  ///< ordered polyline along the ridge
  PointsIn<CtFrame> umbilical_notch;  ///< one point or a few
  PointsIn<CtFrame> vena_cava;        ///< points of the surface attached to it
  /// How far each point of the margin, and the notch, may lie from where they are: a standard deviation
  /// across, metres. 0, and an empty list: a person's own mark, or a sharp edge in the CT.
  Eigen::VectorXd margin_deviation = {};
  double notch_deviation = 0.0;
  bool empty() const { return anterior_margin.rows() == 0 && umbilical_notch.rows() == 0; }
};

/// The biomechanical model of one patient, pre-operative, in the CT's frame. Plain value; built by the model
/// module, read by everything downstream.
struct PatientModel {
  TetMesh mesh;             ///< labels per tetrahedron: structure::kParenchyma or a lesion's
  BoundarySurface surface;  ///< of mesh
  std::vector<VesselTree> vessels;
  std::vector<NamedSurface> surfaces;  ///< fine surfaces: liver, vessels, lesions, vena cava
  Landmarks landmarks;
};

/// Volume-weighted centre of each lesion's tetrahedra, by label; CT frame, metres. Surfaces of lesions too
/// small for a tetrahedron of their own give theirs.
std::vector<std::pair<Label, Eigen::Vector3d>> lesion_centres(const PatientModel& model);

/// Points carried by a mesh: each bound to a tetrahedron by barycentric weights (clamped for points outside).
struct Binding {
  std::vector<int> tetrahedron;
  Eigen::Matrix<double, Eigen::Dynamic, 4, Eigen::RowMajor> weights;
  std::vector<int> outside;  ///< points that lay outside, bound to the closest tetrahedron

  /// Where the points are when the nodes are at `nodes` (N x 3, any one frame).
  Points apply(const TetMesh& mesh, const Points& nodes) const;
};
/// @param clamp weights of outside points are clamped to the tetrahedron; otherwise they extrapolate.
Binding bind_points(const TetMesh& mesh, const Points& points, bool clamp = true);

}  // namespace glisson
