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
/// r the registered nodes, m their masses, y_k and e a line of sight, p_j the tissue that is tracked, which
/// may slide along the surface (it is the binding that was wrong), rho Cauchy's. A registration errs first as
/// a body: s_t = 10 mm about its place. It errs in shape by s = 4 mm over L = 35 mm (the reach of a force
/// that nobody has simulated, see registration/operation_prior.h), whose elastic energy is E L s^2 / 2: T = E
/// L s^2.
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
