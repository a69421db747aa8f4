// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace glisson::fem {

/// Dense kernels of a front, for the widest vectors that the machine has (AVX-512, AVX2, SSE2), chosen once
/// at run time. No fused multiply-add and the same order of sums in all of them: the same bits on every
/// machine.
struct DenseKernels {
  /// Cholesky of the first `columns` columns of the lower trapezoid in `panel` (column-major, `stride` rows
  /// a column, a multiple of 8; rows above the diagonal are scratch). @return false: not positive definite.
  bool (*factor_panel)(double* panel, int stride, int columns);
  /// schur -= B B^T, lower part, B = panel's rows from `columns` on. `stride_schur` (a multiple of 8) columns
  /// of rows are touched; `size` columns, a multiple of 3.
  void (*subtract_product)(double* schur, int stride_schur, int size, const double* panel, int stride,
                           int columns);
  /// x1 = L1^-1 x1, x2 -= L2 x1; `rows` below the square part.
  void (*forward)(const double* panel, int stride, int columns, int rows, double* x1, double* x2);
  /// x1 = L1^-T (x1 - L2^T x2).
  void (*backward)(const double* panel, int stride, int columns, int rows, double* x1, const double* x2);
  const char* name;
};

const DenseKernels& dense_kernels();
/// All that this machine can run, widest first.
std::vector<const DenseKernels*> available_dense_kernels();

}  // namespace glisson::fem
