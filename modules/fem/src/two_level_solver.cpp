// SPDX-License-Identifier: GPL-3.0-or-later
#include "two_level_solver.h"

#include <Eigen/Dense>
#include <cmath>

namespace glisson::fem {
namespace {

/// Lattice nodes for a number of mesh nodes. With few there are many iterations, with many the coarse factor
/// costs much; the measured minimum is flat.
int lattice_nodes(int nodes) { return std::max(8, static_cast<int>(5.0 * std::sqrt(nodes))); }

using Quads = Eigen::Map<Eigen::Matrix<double, 4, Eigen::Dynamic>>;

void clear_fourth(Eigen::VectorXd& v) { Quads(v.data(), 4, v.size() / 4).row(3).setZero(); }

void widen(const Eigen::VectorXd& three, Eigen::VectorXd& four) {
  const Eigen::Index n = three.size() / 3;
  four.setZero(4 * n);
  Quads(four.data(), 4, n).topRows<3>() =
      Eigen::Map<const Eigen::Matrix<double, 3, Eigen::Dynamic>>(three.data(), 3, n);
}

}  // namespace

TwoLevelSolver::TwoLevelSolver(const BlockPattern& fine, const Points& rest, const SweepKernels& kernels)
    : fine_(fine), kernels_(kernels), coarse_(fine, rest, lattice_nodes(fine.unknowns)) {
  const auto n = 4 * static_cast<Eigen::Index>(fine.unknowns);
  for (Eigen::VectorXd* v : {&x_, &r_, &d_, &q_, &z_, &az_, &work_, &left_, &sweep_}) v->setZero(n);
  inverse_.assign(12 * static_cast<std::size_t>(fine.unknowns), 0.0);
}

bool TwoLevelSolver::prepare(const std::vector<double>& values) {
  values_ = values.data();
  for (int c = 0; c < fine_.unknowns; ++c) {
    const Eigen::Map<const Eigen::Matrix3d> block(values_ +
                                                  9L * fine_.column_start[static_cast<std::size_t>(c)]);
    // Sylvester's rule.
    const double determinant = block.determinant();
    if (!(block(0, 0) > 0.0 && block.topLeftCorner<2, 2>().determinant() > 0.0 && determinant > 0.0) ||
        !std::isfinite(determinant))
      return false;
    Eigen::Map<Eigen::Matrix<double, 4, 3>>(inverse_.data() + 12L * c).topRows<3>() = block.inverse();
  }
  return coarse_.factorise(values);
}

/// z = M^-1 r and A z. With u = (L + D)^-1 r, t = P Ac^-1 P^T (r - A u), (L^T + D) e = r - A u - A t:
/// z = u + t + e, and since A u = r + L^T u - (what the sweep left), A z = r + L e.
void TwoLevelSolver::precondition() {
  const int n = fine_.unknowns;
  const int *start = fine_.column_start.data(), *rows = fine_.rows.data();
  work_ = r_;
  kernels_.forward(n, start, rows, values_, inverse_.data(), work_.data(), z_.data());
  kernels_.upper(n, start, rows, values_, z_.data(), left_.data());
  coarse_.correct(left_.data(), work_.data());
  kernels_.subtract(n, start, rows, values_, work_.data(), left_.data());
  z_ += work_;
  kernels_.backward(n, start, rows, values_, inverse_.data(), left_.data(), sweep_.data(), az_.data());
  clear_fourth(az_);
  z_ += sweep_;
  az_ += r_;
}

void TwoLevelSolver::subtract(const Eigen::VectorXd& x, Eigen::VectorXd& r) const {
  kernels_.subtract(fine_.unknowns, fine_.column_start.data(), fine_.rows.data(), values_, x.data(),
                    r.data());
  clear_fourth(r);
}

TwoLevelSolver::Result TwoLevelSolver::solve(const Eigen::VectorXd& b, Eigen::VectorXd& x, double tolerance,
                                             int max_iterations) {
  Result result;
  widen(x, x_);
  widen(b, r_);
  subtract(x_, r_);
  const double size = b.norm(), wanted = tolerance * size;
  d_.setZero();
  q_.setZero();
  double previous = 1.0;
  for (; result.iterations < max_iterations && !(r_.norm() <= wanted); ++result.iterations) {
    precondition();
    const double now = r_.dot(z_), beta = result.iterations == 0 ? 0.0 : now / previous;
    d_ = z_ + beta * d_;
    q_ = az_ + beta * q_;
    const double curvature = d_.dot(q_);
    if (!(now > 0.0 && curvature > 0.0) || !std::isfinite(curvature)) break;
    const double step = now / curvature;
    x_ += step * d_;
    r_ -= step * q_;
    previous = now;
  }
  x = Eigen::Map<const Eigen::Matrix<double, 4, Eigen::Dynamic>>(x_.data(), 4, x_.size() / 4)
          .topRows<3>()
          .reshaped();
  // The residual of the recurrence drifts: the one that is reported is computed from x.
  widen(b, r_);
  subtract(x_, r_);
  result.residual = size > 0.0 ? r_.norm() / size : r_.norm();
  result.converged = result.residual <= 1.1 * tolerance;
  return result;
}

}  // namespace glisson::fem
