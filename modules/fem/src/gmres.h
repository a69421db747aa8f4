// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <functional>

namespace glisson::fem {

using LinearMap = std::function<void(const Eigen::VectorXd&, Eigen::VectorXd&)>;

/// GMRES (Saad and Schultz 1986), preconditioned from the right, without restart: for a matrix that differs
/// from what the preconditioner inverts by little. @return x, with |b - A x| <= tolerance |b| or after
/// max_iterations.
Eigen::VectorXd gmres(const LinearMap& matrix, const LinearMap& preconditioner, const Eigen::VectorXd& b,
                      double tolerance, int max_iterations);

}  // namespace glisson::fem
