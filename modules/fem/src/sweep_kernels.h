// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace glisson::fem {

/// Sweeps over a symmetric block matrix A = L + D + L^T, of which L and D are stored (BlockPattern's order;
/// nine doubles a block, one more readable behind the last). Vectors hold four doubles a node, the fourth
/// zero. The same bits whatever the machine's vectors.
struct SweepKernels {
  /// (L + D) x = r; r is used up. `inverse`: D^-1, 12 doubles a node (three columns of four, fourth zero).
  void (*forward)(int n, const int* start, const int* rows, const double* blocks, const double* inverse,
                  double* r, double* x);
  /// y = -L^T x.
  void (*upper)(int n, const int* start, const int* rows, const double* blocks, const double* x, double* y);
  /// r -= A x; the fourth of each is then anything.
  void (*subtract)(int n, const int* start, const int* rows, const double* blocks, const double* x,
                   double* r);
  /// (L^T + D) x = r and y = L x; the fourth of each y is then anything.
  void (*backward)(int n, const int* start, const int* rows, const double* blocks, const double* inverse,
                   const double* r, double* x, double* y);
};

const SweepKernels& sweep_kernels();
/// All that this machine can run, widest first.
std::vector<const SweepKernels*> available_sweep_kernels();

}  // namespace glisson::fem
