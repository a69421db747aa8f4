// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glisson/fem/composite_model.h"
#include "glisson/insilico/handled_liver.h"
#include "operator_hand.h"

namespace glisson::insilico {

/// What holds a handled liver and what is done to it.
class HandledLoads {
 public:
  /// @param surface of the truth's mesh; @param landmarks complete.
  HandledLoads(const BoundarySurface& surface, const Landmarks& landmarks, const HandlingOptions& options);

  /// The loads at node positions x when the handling has gone `way` far: tools by so many metres, gravity by
  /// way / 0.1 m of its turn, gas by 32 kPa a metre.
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
  /// The liver that a handling is begun on.
  struct Organ {
    const BoundarySurface& surface;
    const Landmarks& landmarks;
    Points normals;         ///< of the surface's vertices
    Eigen::VectorXd areas;  ///< of the same, m2
  };
  void hold(const Organ& organ);
  void handle(Handling handling, const Organ& organ, Hand& hand);
  template <class Accepts>
  static int somewhere(const Organ& organ, Hand& hand, const Accepts& accepts);
  void lift(const Organ& organ, Hand& hand);
  void press(const Organ& organ, Hand& hand);
  void turn(Hand& hand);
  void pull(std::size_t places, const Organ& organ, Hand& hand);
  void inflate(const Organ& organ);
  void take(const Organ& organ, const Eigen::Vector3d& centre, double radius, const Eigen::Vector3d& along);

  std::vector<Hold> tools_;
  std::vector<Rest> hung_, bed_;
  std::vector<int> fixed_;
  Eigen::Vector3d gravity_ = Eigen::Vector3d::Zero();  ///< its change at the end, m/s2
  Eigen::Vector3d carried_ = Eigen::Vector3d::Zero();  ///< the diaphragm's way over that of the handling
  double gas_ = 0.0;                                   ///< Pa a metre of way
  std::vector<int> under_gas_;                         ///< triangles of the surface
  double farthest_ = 0.07;
};

}  // namespace glisson::insilico
