// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "glisson/core/run_context.h"
#include "glisson/geometry/mesh.h"

namespace glisson::insilico {

/// Truth for the registration of a bare organ: held somewhere, pulled or pressed at a few places, seen in
/// part. Like the sequences of Mestdagh and Cotin, but neo-Hookean. What is not given is drawn from the seed.
struct PulledOrganOptions {
  std::uint64_t seed = 1;
  int patches = 0;  ///< that are pulled or pressed, 1 to 3; 0: drawn
  double smallest_patch_cm2 = 2.0, largest_patch_cm2 = 6.0;
  /// How far nodes move in the first frame: as far as both allow.
  double mean_motion_mm = 12.0;    ///< on average, at most
  double largest_motion_mm = 0.0;  ///< any of them, at most; 0: drawn from 30 to 50
  double poisson_ratio = 0.49;
  double held_radius_mm = 24.0;  ///< of the ball in which it is held
  bool hidden_patch = false;     ///< the last patch lies outside of what is seen
  double seen_share = 0.2;       ///< of the surface, of what faces the camera at most
  int points = 500;              ///< of a cloud
  double noise_mm = 0.0;         ///< standard deviation a coordinate
  int frames = 1;                ///< the loads swell and ebb from frame to frame
  /// @throws InputError naming the option.
  void validate() const;
};

/// What is true of one frame.
struct PulledFrame {
  Points nodes;  ///< of the truth's mesh, metres, the rest shape's frame
  Points cloud;  ///< what is seen
};
/// A sequence of one organ, with its truth. The rest shape's frame, metres.
struct PulledOrgan {
  std::vector<PulledFrame> frames;
  Eigen::Vector3d held_centre = Eigen::Vector3d::Zero();     ///< nodes near it do not move
  double held_radius = 0.0;                                  ///< m
  Eigen::Vector3d towards_camera = Eigen::Vector3d::Zero();  ///< unit; the camera is far away
  double mean_motion = 0.0, largest_motion = 0.0;            ///< of the first frame's nodes, m
  int patches = 0;
};

/// Nodes of any mesh of the organ that are held.
std::vector<int> held_nodes(const TetMesh& mesh, const PulledOrgan& organ);

/// @param truth the organ at rest, metres. @throws InputError options, mesh; NumericalError when no
/// equilibrium of the wanted size is found.
Cancellable<PulledOrgan> pull_organ(const TetMesh& truth, const PulledOrganOptions& options,
                                    const RunContext& context);

}  // namespace glisson::insilico
