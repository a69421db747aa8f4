// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <map>
#include <memory>
#include <vector>

#include "glisson/patient/patient_model.h"

namespace glisson::fem {

/// What a constituent of the liver is made of: isotropic, under small strains linear.
struct Material {
  double young_modulus = 3500.0;  ///< Pa
  double poisson_ratio = 0.45;    ///< in [0, 0.5)
};

/// The parenchyma's elastic law; equations in the README.
enum class TetrahedronLaw { corotational, neo_hookean };

/// How the parenchyma's mass stands in the dynamics: a quarter of an element's at each of its nodes, or
/// rho V / 20 (1 + delta_ij), the integral of the shape functions' products.
enum class MassMatrix { lumped, consistent };

/// The constituents of the composite (paper, 2.1.2 and 3.2).
struct CompositeOptions {
  Material parenchyma{3500.0, 0.45};
  /// Somebody has said the parenchyma's Poisson's ratio: where laws are told apart by evidence it is not
  /// asked.
  bool ratio_is_given = false;
  std::map<Label, Material> by_label;  ///< other sub-domains (lesions); missing ones are parenchyma
  Material vessel_wall{620e3, 0.4};
  Material capsule{8e6, 0.45};
  double capsule_thickness = 20e-6;  ///< m
  double wall_fraction = 0.1;        ///< wall thickness over the outer radius
  double density = 1060.0;           ///< kg/m3
  MassMatrix mass = MassMatrix::lumped;
  double rayleigh_mass = 0.1;       ///< 1/s
  double rayleigh_stiffness = 0.1;  ///< s
  bool with_vessels = true, with_capsule = true;
  TetrahedronLaw law = TetrahedronLaw::corotational;

  /// The material of a sub-domain. @param label of the mesh, which need not be one of 16 bits.
  const Material& of(int label) const;
  /// @throws InputError naming the option.
  void validate() const;
};

/// A force on a point of the mesh, which is given by weights on up to four nodes. When the point moves by d
/// from where the force was evaluated, the force is force - tangent * d to first order: `tangent` is minus
/// its derivative, symmetric and positive semi-definite, and enters the system matrix.
struct AttachedLoad {
  std::array<int, 4> nodes{-1, -1, -1, -1};  ///< -1: unused
  std::array<double, 4> weights{};
  Eigen::Vector3d force = Eigen::Vector3d::Zero();    ///< N
  Eigen::Matrix3d tangent = Eigen::Matrix3d::Zero();  ///< N/m
};

/// Where a step puts one of the fixed nodes.
struct PrescribedNode {
  int node = -1;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< m
};

/// External loads of one step. All in the frame in which the node positions are.
struct Loads {
  /// g_new - g_supine, m/s2: under g_supine the CT's shape is an equilibrium.
  Eigen::Vector3d gravity_change = Eigen::Vector3d::Zero();
  double pressure = 0.0;                ///< Pa on the surface, along the inward normal, following it
  std::vector<int> pressure_triangles;  ///< of the boundary surface; empty: all
  std::vector<AttachedLoad> attached;
  std::vector<PrescribedNode> prescribed;  ///< where fixed nodes go in this step; the others stay
};

/// The composite liver: co-rotational P1 tetrahedra, CST membranes on the surface, hollow Timoshenko beams
/// bound by J^T K_v J (eq. 3 to 8). Immutable; everything that depends on the patient alone is computed once
/// here. Thread-safe.
class CompositeModel {
 public:
  /// @throws InputError for inverted, flat or duplicate elements (named), unusable materials.
  CompositeModel(const TetMesh& mesh, const std::vector<VesselTree>& vessels,
                 const CompositeOptions& options);
  ~CompositeModel();
  CompositeModel(const CompositeModel&) = delete;
  CompositeModel& operator=(const CompositeModel&) = delete;

  int node_count() const;
  int beam_count() const;
  const TetMesh& mesh() const;  ///< rest shape
  const BoundarySurface& surface() const;
  const CompositeOptions& options() const;
  const Eigen::VectorXd& lumped_mass() const;  ///< kg, one a node (the row sums of the consistent mass, too)
  /// The mass matrix times one vector a node (velocities give momenta).
  Points mass_times(const Points& per_node) const;

  /// Elastic energy at node positions x, joules.
  double energy(const Points& x) const;
  /// Internal force -dE/dx, N x 3.
  Points internal_force(const Points& x) const;
  /// von Mises stress of each tetrahedron, Pa.
  Eigen::VectorXd von_mises(const Points& x) const;

  struct Impl;
  const Impl& impl() const { return *impl_; }

 private:
  std::unique_ptr<Impl> impl_;
};

/// What of a patient's vessels a CompositeModel takes.
struct BoundVessels {
  int beams = 0;          ///< that stiffen the mesh
  int beams_dropped = 0;  ///< both ends further outside than their radius, or without length once bound
  int nodes_outside = 0;  ///< that lie outside the mesh and are bound to the closest tetrahedron
};
/// @throws InputError a vessel that is no tree of the nodes it has.
BoundVessels bound_vessels(const TetMesh& mesh, const std::vector<VesselTree>& vessels);

}  // namespace glisson::fem
