// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "glisson/fem/composite_model.h"
#include "glisson/registration/moving_surface.h"

namespace glisson::guidance {

/// A place of the model that belongs on a line of sight. In the shape that was registered, metres.
struct SightPull {
  std::array<int, 4> nodes{-1, -1, -1, -1};
  std::array<double, 4> weights{};
  Eigen::Vector3d target = Eigen::Vector3d::Zero();  ///< a point of the line
  Eigen::Vector3d sight = Eigen::Vector3d::UnitZ();  ///< unit; along it nothing is known
  double sigma = 1e-3;                               ///< across it

  Eigen::Vector3d place(const Points& nodes_now) const;
};

/// The registered shape, drawn to what hands have said: the most probable one by
///   E_elastic(x) / T + sum |x_i - r_i|^2 m_i / (2 m s_t^2) + sum |M (x(k) - y_k)|^2 / (2 sigma_k^2)
///   + sum rho(n_j (x(j) - p_j)),  M = I - e e^T,
/// r the registered nodes, m_i their masses and m the sum, y_k and e a point and the direction of a line of
/// sight, p_j tracked tissue, n_j the surface's normal there, rho Cauchy's. Tracked tissue may slide along
/// the surface: it was its binding that was wrong. A registration is expected to err by s_t = 10 mm as a
/// body, and by s = 4 mm in shape over L = 35 mm (an unforeseen force, see registration/operation_prior.h).
/// Such an error has the elastic energy E L s^2 / 2, so T = E L s^2, E the parenchyma's modulus.
class Corrector {
 public:
  /// @param at_rest free of stress in the registered shape. @param surface of the same model.
  Corrector(std::shared_ptr<const fem::CompositeModel> at_rest, registration::MovingSurface surface);

  const Points& registered() const { return registered_; }
  /// @param tracked places of the tissue in that shape, metres.
  /// @return the nodes. @throws InputError where no shape meets the pulls.
  Points solve(const std::vector<SightPull>& pulls, const Points& tracked) const;

 private:
  std::shared_ptr<const fem::CompositeModel> composite_;
  registration::MovingSurface surface_;
  Points registered_;
};

}  // namespace glisson::guidance
