// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "glisson/fem/composite_model.h"
#include "glisson/geometry/topology.h"
#include "glisson/patient/patient_model.h"

namespace glisson::insilico {

/// How far each cause is turned up.
struct LoadLevels {
  double pressure_pa = 0.0;    ///< gas on the anterior and diaphragmatic face
  double tilt = 0.0;           ///< 0: supine; 1: flank and anti-Trendelenburg
  double bed_sinks = 0.0;      ///< metres the organs behind the lobes give way
  double ligament_lift = 0.0;  ///< metres the abdominal wall takes the falciform ligament with it
  double diaphragm = 0.0;      ///< metres the diaphragm comes down
  double heart_n = 0.0;        ///< newton, of the heart on the left dome
  double tool = 0.0;           ///< share of its way that a tool has gone with the tissue it holds
};

/// What a tool holds by a spring.
struct ToolHold {
  int node = 0;
  double stiffness = 0.0;                          ///< N/m
  Eigen::Vector3d from = Eigen::Vector3d::Zero();  ///< where the node was when it was touched
  Eigen::Vector3d way = Eigen::Vector3d::Zero();   ///< metres, at the end
};

/// Gas, gravity, bed, diaphragm, vena cava, ligament and heart on a liver in the CT's frame (LPS). Springs
/// are per area of the face they hold, so that the mesh's density does not matter.
class TheatreLoads {
 public:
  TheatreLoads(const BoundarySurface& surface, const Landmarks& landmarks);

  /// The loads when the nodes are at x. Gas presses along the inward normals of `shape`, the last
  /// equilibrium: a follower load that lags one load step behind, which keeps each equilibrium a minimum of
  /// energy.
  fem::Loads at(const Points& x, const Points& shape, const LoadLevels& levels) const;
  void take_hold(std::vector<ToolHold> held) { tool_ = std::move(held); }
  /// Centre of the nodes that the vena cava holds.
  const Eigen::Vector3d& cava() const { return cava_; }

 private:
  struct Spring {
    int node = 0;
    double stiffness = 0.0;                                 ///< N/m
    Eigen::Vector3d rest = Eigen::Vector3d::Zero();         ///< anchor in the CT
    double follows_diaphragm = 0.0;                         ///< share of the diaphragm's way
    double follows_wall = 0.0;                              ///< share of the ligament's lift
    Eigen::Vector3d follows_bed = Eigen::Vector3d::Zero();  ///< way per metre that the bed sinks
  };
  void hold(const BoundarySurface& surface, const Landmarks& landmarks);

  std::vector<Spring> springs_;
  std::vector<std::array<int, 3>> gas_;        ///< triangles under the gas, nodes of the tetrahedral mesh
  std::vector<std::pair<int, double>> heart_;  ///< node and its share of the force
  std::vector<ToolHold> tool_;                 ///< nothing: no tool
  Eigen::Vector3d cava_ = Eigen::Vector3d::Zero();
};

}  // namespace glisson::insilico
