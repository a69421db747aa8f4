// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "glisson/geometry/mesh.h"

namespace glisson::fem {

/// Elastic laws of a body in static equilibrium, F = deformation gradient, J = det F, mu and lambda Lame's:
///   linear        W = mu |eps|^2 + lambda/2 tr(eps)^2, eps = (F + F^T)/2 - I
///   corotational  W = mu |S - I|^2 + lambda/2 tr(S - I)^2, F = Q S
///   neo_hookean   W = mu/2 (|F|^2 - 3) - mu ln J + lambda/2 (ln J)^2, ln J replaced below J = 0.2 by its
///                 Taylor polynomial of second order there, so that inverted elements are pulled back.
/// CompositeModel's neo-Hookean law is another one (Smith et al. 2018).
enum class BodyLaw { linear, corotational, neo_hookean };
/// "linear", "corotational", "neo_hookean".
const char* body_law_code(BodyLaw law);

/// The law of a whole body. Young's modulus is not in it: see ElasticBody.
struct BodyMaterial {
  BodyLaw law = BodyLaw::neo_hookean;
  double poisson_ratio = 0.45;  ///< (-1, 0.5)
  bool operator==(const BodyMaterial&) const = default;
};

/// Columns of nodal vectors: row 3 i + c is component c of node i.
using NodalColumns = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// A body of linear tetrahedra, some of its nodes fixed: static energy and force under any of the laws, and
/// the factor of its second derivative, for many right-hand sides. The rest shape and the fixed nodes are
/// analysed once; copies share that, and each has its own factor. Const functions are thread-safe.
/// Young's modulus is 1 Pa times the tetrahedron's share: where only shapes are seen its size is no matter.
class ElasticBody {
 public:
  /// @param stiffness of each tetrahedron relative to the others, positive; empty: all 1.
  /// @param fixed_nodes 0-based; may be empty.
  /// @throws InputError flat elements, fixed nodes out of range, all fixed, stiffness. Elements of negative
  ///   orientation are taken as they are.
  ElasticBody(const TetMesh& rest, const std::vector<int>& fixed_nodes, std::vector<double> stiffness = {});
  ElasticBody(const ElasticBody& other);
  ElasticBody& operator=(const ElasticBody&) = delete;
  ~ElasticBody();

  /// @throws InputError Poisson's ratio.
  void set_material(const BodyMaterial& material);
  const BodyMaterial& material() const;
  /// The same body with another rest shape (no analysis). @param rest one row a node, metres.
  /// @throws InputError flat elements.
  void set_rest(const Points& rest);
  const Points& rest() const;
  int node_count() const;
  bool is_fixed(int node) const;
  /// A quarter of the volume of the elements around each node, m3.
  const Eigen::VectorXd& node_volumes() const;

  /// Joules at node positions x; infinite or not a number where x is. @pre one row a node.
  double energy(const Points& x) const;
  /// The same, and its gradient dE/dx, N x 3, fixed nodes included.
  double energy(const Points& x, Points& gradient) const;
  /// The energy's second derivative, each element's negative eigenvalues set to zero (or not), dense, all
  /// nodes: for tests.
  Eigen::MatrixXd hessian(const Points& x, bool projected) const;
  /// Elements with J <= 0.
  int inverted(const Points& x) const;

  /// Factorises the projected second derivative at x plus `springs` (N/m, one a node, isotropic; empty:
  /// none) on the free nodes. @return false: not positive definite; the factor is then of no use.
  bool factorise(const Points& x, const Eigen::VectorXd& springs);
  /// Solves for every column in place; rows of fixed nodes become zero. @pre factorise() succeeded.
  void solve(NodalColumns& b);
  /// One right-hand side: forces (N, one row a node) give displacements (m). Rows of fixed nodes are not read
  /// and come back as zero. @pre factorise() succeeded.
  Points solve(const Points& b);

 private:
  struct Shared;
  struct Element;
  void assemble(const Points& x, const Eigen::VectorXd& springs);

  std::shared_ptr<const Shared> shared_;
  std::vector<Element> elements_;
  Points rest_;
  Eigen::VectorXd node_volumes_;
  BodyMaterial material_;
  struct Factor;
  std::unique_ptr<Factor> factor_;
};

}  // namespace glisson::fem
