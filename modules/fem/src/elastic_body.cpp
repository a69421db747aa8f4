// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/fem/elastic_body.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "block_matrix.h"
#include "body_law.h"
#include "glisson/core/error.h"
#include "multifrontal_factorization.h"

namespace glisson::fem {

struct ElasticBody::Shared {
  BlockPattern pattern;
  /// Of each element: its nodes in the order of their unknowns, and the blocks (i >= j) that they couple.
  std::vector<std::array<int, 4>> nodes;
  std::vector<std::array<int, 10>> blocks;
  std::vector<double> stiffness;
};

struct ElasticBody::Element {
  Eigen::Matrix<double, 3, 4> gradients;  ///< of the shape functions, 1/m
  double volume;                          ///< m3
};

struct ElasticBody::Factor {
  explicit Factor(const BlockPattern& pattern)
      : values(static_cast<std::size_t>(pattern.block_count() + 1) * 9), solver(pattern) {}
  std::vector<double> values;  ///< and a spare block behind them, where the fixed nodes' go
  MultifrontalFactorization solver;
};

namespace {

Eigen::Matrix3d gradient_of(const Points& x, const std::array<int, 4>& nodes,
                            const Eigen::Matrix<double, 3, 4>& gradients) {
  Eigen::Matrix3d f = Eigen::Matrix3d::Zero();
  for (int k = 1; k < 4; ++k)
    f.noalias() += (x.row(nodes[static_cast<std::size_t>(k)]) - x.row(nodes[0])).transpose() *
                   gradients.col(k).transpose();
  return f;
}

/// Block (a, b) of an element's second derivative in principal axes; g = V^T grad N.
Eigen::Matrix3d principal_block(const PrincipalCurvature& c, const Eigen::Vector3d& ga,
                                const Eigen::Vector3d& gb) {
  Eigen::Matrix3d block;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (i != j) block(i, j) = c.scaling(i, j) * ga[i] * gb[j] + c.cross[3 - i - j] * ga[j] * gb[i];
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    block(i, i) = c.scaling(i, i) * ga[i] * gb[i] + c.same[k] * ga[j] * gb[j] + c.same[j] * ga[k] * gb[k];
  }
  return block;
}

}  // namespace

ElasticBody::ElasticBody(const TetMesh& rest, const std::vector<int>& fixed_nodes,
                         std::vector<double> stiffness) {
  auto shared = std::make_shared<Shared>();
  const auto count = static_cast<std::size_t>(rest.tetrahedron_count());
  if (stiffness.empty()) stiffness.assign(count, 1.0);
  if (stiffness.size() != count || std::any_of(stiffness.begin(), stiffness.end(),
                                               [](double e) { return !(e > 0.0) || !std::isfinite(e); }))
    throw InputError("stiffness", "", "must be one positive number a tetrahedron", "Give relative moduli");
  shared->stiffness = std::move(stiffness);
  std::vector<std::array<int, 2>> couplings;
  for (int t = 0; t < rest.tetrahedron_count(); ++t)
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < i; ++j) couplings.push_back({rest.tetrahedra(t, i), rest.tetrahedra(t, j)});
  shared->pattern = make_pattern(rest.vertex_count(), couplings, fixed_nodes, Ordering::fill_reducing);
  const auto unknown = [&](int node) {
    return shared->pattern.unknown_of_node[static_cast<std::size_t>(node)];
  };
  for (int t = 0; t < rest.tetrahedron_count(); ++t) {
    std::array<int, 4> nodes{};
    for (int k = 0; k < 4; ++k) nodes[static_cast<std::size_t>(k)] = rest.tetrahedra(t, k);
    std::sort(nodes.begin(), nodes.end(), [&](int a, int b) { return unknown(a) < unknown(b); });
    std::array<int, 10> blocks{};
    std::size_t next = 0;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j <= i; ++j)
        blocks[next++] = unknown(nodes[j]) < 0 ? shared->pattern.block_count()
                                               : shared->pattern.find(unknown(nodes[i]), unknown(nodes[j]));
    shared->nodes.push_back(nodes);
    shared->blocks.push_back(blocks);
  }
  shared_ = std::move(shared);
  set_rest(rest.vertices);
}

ElasticBody::ElasticBody(const ElasticBody& other)
    : shared_(other.shared_),
      elements_(other.elements_),
      rest_(other.rest_),
      node_volumes_(other.node_volumes_),
      material_(other.material_) {}

ElasticBody::~ElasticBody() = default;

void ElasticBody::set_material(const BodyMaterial& material) {
  const LawConstants checked(material);
  material_ = material;
}

const BodyMaterial& ElasticBody::material() const { return material_; }
const Points& ElasticBody::rest() const { return rest_; }
int ElasticBody::node_count() const { return static_cast<int>(rest_.rows()); }
const Eigen::VectorXd& ElasticBody::node_volumes() const { return node_volumes_; }

bool ElasticBody::is_fixed(int node) const {
  return shared_->pattern.unknown_of_node[static_cast<std::size_t>(node)] < 0;
}

void ElasticBody::set_rest(const Points& rest) {
  std::vector<Element> elements;
  Eigen::VectorXd volumes = Eigen::VectorXd::Zero(rest.rows());
  for (std::size_t t = 0; t < shared_->nodes.size(); ++t) {
    const auto& nodes = shared_->nodes[t];
    Eigen::Matrix3d edges;
    for (int k = 0; k < 3; ++k)
      edges.col(k) = (rest.row(nodes[static_cast<std::size_t>(k) + 1]) - rest.row(nodes[0])).transpose();
    Element e;
    e.volume = std::abs(edges.determinant()) / 6.0;
    if (!(e.volume > 0.0) || !std::isfinite(e.volume))
      throw InputError("mesh", "tetrahedron " + std::to_string(t), "is flat", "Mend the mesh");
    e.gradients.rightCols<3>() = edges.inverse().transpose();
    e.gradients.col(0) = -e.gradients.rightCols<3>().rowwise().sum();
    for (const int node : nodes) volumes[node] += 0.25 * e.volume;
    elements.push_back(e);
  }
  elements_ = std::move(elements);
  node_volumes_ = std::move(volumes);
  rest_ = rest;
}

double ElasticBody::energy(const Points& x) const {
  const LawConstants law(material_);
  double sum = 0.0;
  for (std::size_t t = 0; t < elements_.size(); ++t)
    sum += shared_->stiffness[t] * elements_[t].volume *
           density(law, gradient_of(x, shared_->nodes[t], elements_[t].gradients));
  return sum;
}

double ElasticBody::energy(const Points& x, Points& gradient) const {
  const LawConstants law(material_);
  gradient.setZero(x.rows(), 3);
  double sum = 0.0;
  Eigen::Matrix3d stress;
  for (std::size_t t = 0; t < elements_.size(); ++t) {
    const Element& e = elements_[t];
    const auto& nodes = shared_->nodes[t];
    const double weight = shared_->stiffness[t] * e.volume;
    sum += weight * density(law, gradient_of(x, nodes, e.gradients), stress);
    const Eigen::Matrix<double, 3, 4> forces = (weight * stress) * e.gradients;
    for (int k = 0; k < 4; ++k) gradient.row(nodes[static_cast<std::size_t>(k)]) += forces.col(k).transpose();
  }
  return sum;
}

int ElasticBody::inverted(const Points& x) const {
  int count = 0;
  for (std::size_t t = 0; t < elements_.size(); ++t)
    count += !(gradient_of(x, shared_->nodes[t], elements_[t].gradients).determinant() > 0.0);
  return count;
}

Eigen::MatrixXd ElasticBody::hessian(const Points& x, bool projected) const {
  const LawConstants law(material_);
  Eigen::MatrixXd h = Eigen::MatrixXd::Zero(3 * x.rows(), 3 * x.rows());
  for (std::size_t t = 0; t < elements_.size(); ++t) {
    const Element& e = elements_[t];
    const auto& nodes = shared_->nodes[t];
    const PrincipalCurvature c = curvature(law, gradient_of(x, nodes, e.gradients), projected);
    const Eigen::Matrix<double, 3, 4> g = c.v.transpose() * e.gradients;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < 4; ++j)
        h.block<3, 3>(3L * nodes[i], 3L * nodes[j]) +=
            shared_->stiffness[t] * e.volume * c.u *
            principal_block(c, g.col(static_cast<Eigen::Index>(i)), g.col(static_cast<Eigen::Index>(j))) *
            c.u.transpose();
  }
  return h;
}

void ElasticBody::assemble(const Points& x, const Eigen::VectorXd& springs) {
  const LawConstants law(material_);
  std::vector<double>& values = factor_->values;
  std::fill(values.begin(), values.end(), 0.0);
  for (std::size_t t = 0; t < elements_.size(); ++t) {
    const Element& e = elements_[t];
    const PrincipalCurvature c = curvature(law, gradient_of(x, shared_->nodes[t], e.gradients), true);
    const Eigen::Matrix<double, 3, 4> g = c.v.transpose() * e.gradients;
    const Eigen::Matrix3d turned = (shared_->stiffness[t] * e.volume) * c.u;
    std::size_t next = 0;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j <= i; ++j, ++next) {
        const Eigen::Matrix3d half = turned * principal_block(c, g.col(i), g.col(j));
        Eigen::Map<Eigen::Matrix3d>(values.data() + 9L * shared_->blocks[t][next]).noalias() +=
            half.lazyProduct(c.u.transpose());
      }
  }
  if (springs.size() == 0) return;
  const BlockPattern& pattern = shared_->pattern;
  for (int u = 0; u < pattern.unknowns; ++u) {
    double* block = values.data() + 9L * pattern.column_start[static_cast<std::size_t>(u)];
    for (int k = 0; k < 3; ++k) block[4 * k] += springs[pattern.node_of_unknown[static_cast<std::size_t>(u)]];
  }
}

bool ElasticBody::factorise(const Points& x, const Eigen::VectorXd& springs) {
  if (!factor_) factor_ = std::make_unique<Factor>(shared_->pattern);
  assemble(x, springs);
  return factor_->solver.factorise(factor_->values);
}

void ElasticBody::solve(NodalColumns& b) {
  const BlockPattern& pattern = shared_->pattern;
  RightHandSides x(3L * pattern.unknowns, b.cols());
  for (int u = 0; u < pattern.unknowns; ++u)
    x.middleRows<3>(3L * u) = b.middleRows<3>(3L * pattern.node_of_unknown[static_cast<std::size_t>(u)]);
  factor_->solver.solve_many(x);
  b.setZero();
  for (int u = 0; u < pattern.unknowns; ++u)
    b.middleRows<3>(3L * pattern.node_of_unknown[static_cast<std::size_t>(u)]) = x.middleRows<3>(3L * u);
}

Points ElasticBody::solve(const Points& b) {
  const BlockPattern& pattern = shared_->pattern;
  Eigen::VectorXd x(3L * pattern.unknowns);
  for (int u = 0; u < pattern.unknowns; ++u)
    x.segment<3>(3L * u) = b.row(pattern.node_of_unknown[static_cast<std::size_t>(u)]).transpose();
  factor_->solver.solve(x);
  Points result = Points::Zero(b.rows(), 3);
  for (int u = 0; u < pattern.unknowns; ++u)
    result.row(pattern.node_of_unknown[static_cast<std::size_t>(u)]) = x.segment<3>(3L * u).transpose();
  return result;
}

}  // namespace glisson::fem
