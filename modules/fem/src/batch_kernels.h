// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace glisson::fem {

inline constexpr int kLanes = 8;

/// Eight co-rotational tetrahedra side by side. Nodes are in the order of their unknowns, so that the block
/// of nodes i >= j is stored as it comes. Empty lanes have no stiffness and point at the spare block.
struct alignas(64) TetrahedronGroup {
  double gradients[9][kLanes];        ///< of nodes 1 to 3, x y z each
  double dots[10][kLanes];            ///< mu volume g_i . g_j, i >= j
  double lambda[kLanes], mu[kLanes];  ///< times the volume
  int node[4][kLanes];
  int slot[10][kLanes];  ///< block of nodes i >= j
};

/// Eight membranes, likewise.
struct alignas(64) MembraneGroup {
  double gradients[4][kLanes];  ///< of nodes 1 and 2, in the rest plane
  double dots[6][kLanes];
  double lambda[kLanes], mu[kLanes];  ///< times thickness and area
  int node[3][kLanes];
  int slot[6][kLanes];
};

/// Adds `scale` times R^T K0 R to the 3 x 3 blocks (column-major) in `values`, and the elements' internal
/// force to `force`; x and force hold three numbers a node. The same bits whatever the machine's vectors.
struct BatchKernels {
  void (*tetrahedra)(const TetrahedronGroup* groups, int count, double scale, const double* x, double* values,
                     double* force);
  void (*membranes)(const MembraneGroup* groups, int count, double scale, const double* x, double* values,
                    double* force);
};

const BatchKernels& batch_kernels();
/// All that this machine can run, widest first.
std::vector<const BatchKernels*> available_batch_kernels();

}  // namespace glisson::fem
