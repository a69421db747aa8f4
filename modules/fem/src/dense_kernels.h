// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace glisson::fem {

/// Columns of a panel that are factorised as one block.
inline constexpr int kPanelBlock = 96;

/// Right-hand sides that are solved for side by side.
inline constexpr int kSolveWidth = 32;

/// Dense kernels of a front, for the widest vectors that the machine has (AVX-512, AVX2, SSE2), chosen once
/// at run time. No fused multiply-add and the same order of sums in all of them: the same bits on every
/// machine.
struct DenseKernels {
  // A panel is column-major, `stride` rows a column (a multiple of 8); rows above the diagonal are scratch.
  // Its columns are factorised in blocks from the left, each in three steps, two of which can be shared out
  // by rows: a row's bits do not depend on who else is worked on. `from` and `to` are multiples of 8.

  /// Takes what the columns before `first` contribute from columns [first, first + width), in rows [from,
  /// to).
  void (*update_block)(double* panel, int stride, int first, int width, int from, int to);
  /// Cholesky of updated columns in their rows up to `to`, beyond the block's own at least. `inverse`
  /// receives one over each pivot's root. @return false: not positive definite.
  bool (*factor_block)(double* panel, int stride, int first, int width, int to, double* inverse);
  /// The same columns in rows [from, to), below those that factor_block did.
  void (*solve_block)(double* panel, int stride, int first, int width, int from, int to,
                      const double* inverse);
  /// Columns [from, to) of schur -= B B^T, lower part, B = panel's rows from `columns` on. `stride_schur` (a
  /// multiple of 8) rows are touched; `from` is a multiple of 6, `to` of 6 or the last column.
  void (*subtract_product)(double* schur, int stride_schur, int from, int to, const double* panel, int stride,
                           int columns);
  /// x1 = L1^-1 x1, x2 -= L2 x1; `rows` below the square part.
  void (*forward)(const double* panel, int stride, int columns, int rows, double* x1, double* x2);
  /// x1 = L1^-T (x1 - L2^T x2).
  void (*backward)(const double* panel, int stride, int columns, int rows, double* x1, const double* x2);
  // The same for kSolveWidth right-hand sides: y holds so many numbers a row, first those of the columns,
  // then those of the rows below.

  /// y1 = L1^-1 y1, y2 -= L2 y1.
  void (*forward_many)(const double* panel, int stride, int columns, int rows, double* y);
  /// y1 = L1^-T (y1 - L2^T y2).
  void (*backward_many)(const double* panel, int stride, int columns, int rows, double* y);
  const char* name;
};

const DenseKernels& dense_kernels();
/// All that this machine can run, widest first.
std::vector<const DenseKernels*> available_dense_kernels();

}  // namespace glisson::fem
