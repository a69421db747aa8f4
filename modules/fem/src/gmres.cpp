// SPDX-License-Identifier: GPL-3.0-or-later
#include "gmres.h"

#include <Eigen/Dense>
#include <vector>

namespace glisson::fem {

Eigen::VectorXd gmres(const LinearMap& matrix, const LinearMap& preconditioner, const Eigen::VectorXd& b,
                      double tolerance, int max_iterations) {
  const double size = b.norm();
  Eigen::VectorXd x = Eigen::VectorXd::Zero(b.size());
  if (!(size > 0.0)) return x;
  std::vector<Eigen::VectorXd> basis{b / size}, turned;
  Eigen::MatrixXd hessenberg = Eigen::MatrixXd::Zero(max_iterations + 1, max_iterations);
  Eigen::VectorXd coefficients;
  for (int k = 0; k < max_iterations; ++k) {
    Eigen::VectorXd w, p;
    preconditioner(basis.back(), p);
    matrix(p, w);
    turned.push_back(std::move(p));
    for (int i = 0; i <= k; ++i) {  // modified Gram-Schmidt
      const Eigen::VectorXd& v = basis[static_cast<std::size_t>(i)];
      hessenberg(i, k) = v.dot(w);
      w -= hessenberg(i, k) * v;
    }
    hessenberg(k + 1, k) = w.norm();
    // Few columns: the least-squares problem is solved anew, rather than updated by rotations.
    const auto h = hessenberg.topLeftCorner(k + 2, k + 1);
    const Eigen::VectorXd right = size * Eigen::VectorXd::Unit(k + 2, 0);
    coefficients = h.colPivHouseholderQr().solve(right);
    const double left = (right - h * coefficients).norm();
    if (!(left > tolerance * size) || hessenberg(k + 1, k) <= 1e-14 * size) break;
    basis.push_back(w / hessenberg(k + 1, k));
  }
  for (Eigen::Index k = 0; k < coefficients.size(); ++k)
    x += coefficients[k] * turned[static_cast<std::size_t>(k)];
  return x;
}

}  // namespace glisson::fem
