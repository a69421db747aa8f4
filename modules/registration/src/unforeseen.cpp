// SPDX-License-Identifier: GPL-3.0-or-later
#include "unforeseen.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "force_patches.h"

namespace glisson::registration {
namespace {

constexpr double kGround = 0.05, kGroundLength = 0.1;  ///< springs over the volume times E / m2
constexpr Eigen::Index kAtOnce = 96;                   ///< columns solved for together
constexpr double kNothing = 1e-6;                      ///< variance of a component over the largest: rounding

/// What a unit force does in each patch and direction. No columns: the body cannot be held.
fem::NodalColumns responses_of(const PatientModel& model, const Unforeseen& forces,
                               const RunContext& context) {
  const fem::NodalColumns none(3L * model.mesh.vertex_count(), 0);
  fem::ElasticBody body(model.mesh, forces.fixed_nodes, forces.stiffness);
  body.set_material({fem::BodyLaw::linear, 0.45});
  Eigen::VectorXd springs;
  if (forces.fixed_nodes.empty()) springs = kGround / (kGroundLength * kGroundLength) * body.node_volumes();
  if (context.cancelled() || !body.factorise(body.rest(), springs)) return none;
  std::vector<char> fixed(static_cast<std::size_t>(body.node_count()), 0);
  for (const int node : forces.fixed_nodes) fixed[static_cast<std::size_t>(node)] = 1;
  const ForceSurface surface(model.surface, model.mesh.vertices, fixed);
  fem::NodalColumns columns = unit_forces(
      surface.patches(model.surface.mesh.vertices, {forces.patch_spacing, forces.patch_radius, 1e-3}),
      body.node_count());
  for (Eigen::Index first = 0; first < columns.cols(); first += kAtOnce) {
    if (context.cancelled()) return none;
    fem::NodalColumns some = columns.middleCols(first, std::min(kAtOnce, columns.cols() - first));
    body.solve(some);
    columns.middleCols(first, some.cols()) = some;
  }
  return columns;
}

/// Orthonormal: the six small rigid motions.
Eigen::MatrixXd rigid_motions(const Points& nodes) {
  Eigen::MatrixXd rigid(nodes.size(), 6);
  const Eigen::RowVector3d middle = nodes.colwise().mean();
  for (Eigen::Index i = 0; i < nodes.rows(); ++i) {
    const Eigen::Vector3d arm = (nodes.row(i) - middle).transpose();
    rigid.block<3, 3>(3 * i, 0) << 0, arm.z(), -arm.y(), -arm.z(), 0, arm.x(), arm.y(), -arm.x(), 0;
    rigid.block<3, 3>(3 * i, 3).setIdentity();
  }
  return Eigen::HouseholderQR<Eigen::MatrixXd>(rigid).householderQ() *
         Eigen::MatrixXd::Identity(nodes.size(), 6);
}

}  // namespace

fem::NodalColumns unforeseen_motions(const PatientModel& model, const Unforeseen& forces,
                                     const RunContext& context) {
  Eigen::MatrixXd motions = responses_of(model, forces, context);
  if (motions.cols() == 0 || !(forces.motion > 0.0)) return fem::NodalColumns(motions.rows(), 0);
  if (forces.fixed_nodes.empty()) {
    const Eigen::MatrixXd rigid = rigid_motions(model.mesh.vertices);
    motions -= rigid * (rigid.transpose() * motions).eval();
  }
  motions *= forces.motion * std::sqrt(static_cast<double>(model.mesh.vertex_count())) / motions.norm();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(Eigen::MatrixXd(motions.transpose() * motions));
  const Eigen::VectorXd& squares = eigen.eigenvalues();
  const Eigen::Index sound = (squares.array() > kNothing * squares.maxCoeff()).count();
  const Eigen::Index kept = std::min<Eigen::Index>(sound, forces.modes);
  return motions * eigen.eigenvectors().rightCols(kept).rowwise().reverse();
}

}  // namespace glisson::registration
