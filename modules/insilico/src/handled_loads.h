// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glisson/fem/composite_model.h"
#include "glisson/insilico/handled_liver.h"

namespace glisson::insilico {

/// What holds a handled liver and what is done to it.
class HandledLoads {
 public:
  /// @param surface of the truth's mesh; @param landmarks complete.
  HandledLoads(const BoundarySurface& surface, const Landmarks& landmarks, const HandlingOptions& options);

  /// The loads at node positions x when the handling has gone `way` far: tools by so many metres, gravity by
  /// way / 0.1 m of its turn.
  fem::Loads at(const Points& x, double way) const;
  /// How far the handling may go, metres.
  double farthest() const { return farthest_; }
  /// Nodes that do not move.
  const std::vector<int>& fixed() const { return fixed_; }

 private:
  /// Tissue in a tool: springs whose ends go with it.
  struct Hold {
    int node = 0;
    double stiffness = 0.0;  ///< N/m
    Eigen::Vector3d rest, along;
  };
  struct Rest {
    int node = 0;
    double stiffness = 0.0;  ///< N/m
    Eigen::Vector3d rest;
  };
  void take(const BoundarySurface& surface, const Eigen::Vector3d& centre, double radius,
            const Eigen::Vector3d& along);

  std::vector<Hold> tools_;
  std::vector<Rest> hung_, bed_;
  std::vector<int> fixed_;
  Eigen::Vector3d gravity_ = Eigen::Vector3d::Zero();  ///< its change at the end, m/s2
  double farthest_ = 0.07;
};

}  // namespace glisson::insilico
