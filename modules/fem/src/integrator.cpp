// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/fem/integrator.h"

#include <cmath>

#include "block_matrix.h"
#include "external_loads.h"
#include "factorization.h"
#include "glisson/core/error.h"

namespace glisson::fem {

void IntegratorOptions::validate() const {
  if (!(time_step >= 1e-6 && time_step <= 10.0))
    throw InputError("integrator options", "time_step", "is " + std::to_string(time_step) + " s",
                     "Give a step between 1e-6 and 10 s");
}

struct Integrator::Impl {
  std::shared_ptr<const CompositeModel> model;
  IntegratorOptions options;
  BlockSystem system;
  std::unique_ptr<Factorization> factorization;
  Points x, v;
  Points force;
  Eigen::VectorXd solution, right, product;

  Impl(std::shared_ptr<const CompositeModel> m, const IntegratorOptions& o)
      : model(std::move(m)),
        options(o),
        system(model->impl(), o.fixed_nodes),
        factorization(make_factorization(o.solver, system.pattern())),
        x(model->mesh().vertices),
        v(Points::Zero(x.rows(), 3)) {}

  int inverted() const {
    int count = 0;
    for (const Tetrahedron& e : model->impl().tetrahedra) {
      const Eigen::Vector3d a = x.row(e.nodes[0]).transpose();
      const Eigen::Vector3d b = x.row(e.nodes[1]).transpose() - a, c = x.row(e.nodes[2]).transpose() - a,
                            d = x.row(e.nodes[3]).transpose() - a;
      count += b.cross(c).dot(d) <= 0.0;
    }
    return count;
  }
};

Integrator::Integrator(std::shared_ptr<const CompositeModel> model, const IntegratorOptions& options) {
  require(model != nullptr, "an integrator needs a model");
  options.validate();
  impl_ = std::make_unique<Impl>(std::move(model), options);
}
Integrator::~Integrator() = default;
Integrator::Integrator(Integrator&&) noexcept = default;
Integrator& Integrator::operator=(Integrator&&) noexcept = default;

const Points& Integrator::positions() const { return impl_->x; }
const Points& Integrator::velocities() const { return impl_->v; }

void Integrator::set_state(const Points& positions) {
  set_state(positions, Points::Zero(positions.rows(), 3));
}

void Integrator::set_state(const Points& positions, const Points& velocities) {
  const auto n = impl_->model->node_count();
  require(positions.rows() == n && velocities.rows() == n, "a state holds one row a node of the model");
  require(positions.allFinite() && velocities.allFinite(), "a state is finite");
  impl_->x = positions;
  impl_->v = velocities;
  for (const int node : impl_->options.fixed_nodes) impl_->v.row(node).setZero();
}

void Integrator::stop() { impl_->v.setZero(); }

StepSummary Integrator::step(const Loads& loads) {
  Impl& s = *impl_;
  const CompositeModel::Impl& model = s.model->impl();
  check_loads(model, loads);
  const double dt = s.options.time_step;
  const CompositeOptions& o = model.options;
  StepSummary summary;
  // (M (1/dt2 + r_M/dt) + (1 + r_K/dt) K + K_ext) dx = M v / dt + f
  s.system.assemble(s.x, 1.0 + o.rayleigh_stiffness / dt, Tangent::rotated, s.force);
  s.system.add_diagonal(model.lumped_mass, 1.0 / (dt * dt) + o.rayleigh_mass / dt);
  add_external_tangent(model, loads, s.x, Tangent::rotated, s.system);
  add_external_force(model, loads, s.x, s.force);
  s.force += model.lumped_mass.asDiagonal() * s.v / dt;
  s.right = s.system.gather(s.force);
  summary.ok = s.right.allFinite() && s.factorization->factorise(s.system.values());
  if (!summary.ok) return summary;
  s.solution = s.right;
  s.factorization->solve(s.solution);
  summary.ok = s.solution.allFinite();
  if (!summary.ok) return summary;
  s.system.multiply(s.solution, s.product);
  const double size = s.right.norm();
  summary.residual = size > 0.0 ? (s.right - s.product).norm() / size : 0.0;
  const BlockPattern& pattern = s.system.pattern();
  s.v.setZero();
  for (int u = 0; u < pattern.unknowns; ++u) {
    const int node = pattern.node_of_unknown[static_cast<std::size_t>(u)];
    s.x.row(node) += s.solution.segment<3>(3 * u).transpose();
    s.v.row(node) = s.solution.segment<3>(3 * u).transpose() / dt;
  }
  summary.kinetic_energy = 0.5 * model.lumped_mass.dot(s.v.rowwise().squaredNorm());
  summary.inverted_tetrahedra = s.inverted();
  return summary;
}

}  // namespace glisson::fem
