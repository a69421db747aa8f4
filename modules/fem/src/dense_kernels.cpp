// SPDX-License-Identifier: GPL-3.0-or-later
#include "dense_kernels.h"

#include <algorithm>
#include <cmath>

#include "unaligned_vector.h"

// One body, compiled three times: always_inline templates on the vector type, inside functions that name
// their target.

namespace glisson::fem {
namespace {

constexpr int kPanel = 12;               ///< columns whose rows stay in registers
constexpr int kDeep = 192, kTall = 768;  ///< of a piece of a product: about a megabyte

/// c (MV vectors x NR columns) -= sum over k of a(:, k) b(:, k)^T.
template <int Bytes, int MV, int NR>
GLISSON_INLINE void tile(double* c, int stride_c, const double* a, const double* b, int stride, int depth) {
  using V = typename Vector<Bytes>::type;
  constexpr int kLanes = Bytes / 8;
  V sum[NR][MV];
#pragma GCC unroll 8
  for (int j = 0; j < NR; ++j)
#pragma GCC unroll 8
    for (int i = 0; i < MV; ++i) sum[j][i] = at<Bytes>(c + static_cast<long>(j) * stride_c + i * kLanes).v;
  for (int k = 0; k < depth; ++k, a += stride, b += stride) {
    V rows[MV];
#pragma GCC unroll 8
    for (int i = 0; i < MV; ++i) rows[i] = at<Bytes>(a + i * kLanes).v;
#pragma GCC unroll 8
    for (int j = 0; j < NR; ++j) {
      const double factor = b[j];
#pragma GCC unroll 8
      for (int i = 0; i < MV; ++i) sum[j][i] -= rows[i] * factor;
    }
  }
#pragma GCC unroll 8
  for (int j = 0; j < NR; ++j)
#pragma GCC unroll 8
    for (int i = 0; i < MV; ++i) at<Bytes>(c + static_cast<long>(j) * stride_c + i * kLanes).v = sum[j][i];
}

/// The same for `rows` rows (a multiple of 8) in the tallest tiles that fit the registers.
template <int Bytes, int NR>
GLISSON_INLINE void column_tiles(double* c, int stride_c, const double* a, const double* b, int stride,
                                 int depth, int rows) {
  int i = 0;
  if constexpr (Bytes == 64) {
    for (; i + 32 <= rows; i += 32) tile<64, 4, NR>(c + i, stride_c, a + i, b, stride, depth);
    if (i + 16 <= rows) {
      tile<64, 2, NR>(c + i, stride_c, a + i, b, stride, depth);
      i += 16;
    }
    if (i < rows) tile<64, 1, NR>(c + i, stride_c, a + i, b, stride, depth);
  } else {
    constexpr int kRows = 2 * Bytes / 8;
    for (; i < rows; i += kRows) tile<Bytes, 2, NR>(c + i, stride_c, a + i, b, stride, depth);
  }
}

template <int Bytes>
GLISSON_INLINE void update_columns(double* c, int stride_c, const double* a, const double* b, int stride,
                                   int depth, int rows, int columns) {
  int j = 0;
  for (; j + 6 <= columns; j += 6)
    column_tiles<Bytes, 6>(c + static_cast<long>(j) * stride_c, stride_c, a, b + j, stride, depth, rows);
  if (j < columns)
    column_tiles<Bytes, 3>(c + static_cast<long>(j) * stride_c, stride_c, a, b + j, stride, depth, rows);
}

/// Rows times L^-T for a triangle of N columns: x_j = (b_j - sum_l x_l L(j, l)) / L(j, j).
template <int Bytes, int N>
GLISSON_INLINE void solve_rows(double* panel, int stride, int rows, const double (*l)[kPanel],
                               const double* inverse) {
  using V = typename Vector<Bytes>::type;
  for (int i = 0; i < rows; i += Bytes / 8) {
    V x[N];
#pragma GCC unroll 12
    for (int j = 0; j < N; ++j) {
      V value = at<Bytes>(panel + static_cast<long>(j) * stride + i).v;
#pragma GCC unroll 12
      for (int k = 0; k < j; ++k) value -= x[k] * l[j][k];
      x[j] = value * inverse[j];
      at<Bytes>(panel + static_cast<long>(j) * stride + i).v = x[j];
    }
  }
}

GLISSON_INLINE bool small_cholesky(const double* panel, int stride, int n, double (*l)[kPanel],
                                   double* inverse) {
  for (int j = 0; j < n; ++j)
    for (int i = j; i < n; ++i) l[i][j] = panel[static_cast<long>(j) * stride + i];
  for (int j = 0; j < n; ++j) {
    double pivot = l[j][j];
    for (int k = 0; k < j; ++k) pivot -= l[j][k] * l[j][k];
    if (!(pivot > 0.0) || !std::isfinite(pivot)) return false;
    const double root = __builtin_sqrt(pivot);
    l[j][j] = root;
    inverse[j] = 1.0 / root;
    for (int i = j + 1; i < n; ++i) {
      double value = l[i][j];
      for (int k = 0; k < j; ++k) value -= l[i][k] * l[j][k];
      l[i][j] = value * inverse[j];
    }
  }
  return true;
}

template <int Bytes>
GLISSON_INLINE void solve_columns(double* here, int stride, int rows, int n, const double (*l)[kPanel],
                                  const double* inverse) {
  switch (n) {
    case 3:
      solve_rows<Bytes, 3>(here, stride, rows, l, inverse);
      break;
    case 6:
      solve_rows<Bytes, 6>(here, stride, rows, l, inverse);
      break;
    case 9:
      solve_rows<Bytes, 9>(here, stride, rows, l, inverse);
      break;
    default:
      solve_rows<Bytes, 12>(here, stride, rows, l, inverse);
  }
}

/// Columns [first, last) of c, rows [from, to) -= A B^T: row r of A is a + r, row j of B is b + j, `columns`
/// long. In pieces of A that stay in the cache while all bands of columns pass over them. The depth comes in
/// the same order as in one go: the same bits.
template <int Bytes>
GLISSON_INLINE void subtract_lower(double* c, int stride_c, int first, int last, int from, int to,
                                   const double* a, int stride, int columns) {
  for (int deep = 0; deep < columns; deep += kDeep) {
    const int depth = std::min(kDeep, columns - deep);
    const double* here = a + static_cast<long>(deep) * stride;
    for (int r = from; r < to; r += kTall) {
      const int end = std::min(to, r + kTall);
      // Bands of columns, so that a tile's rows start at or above the diagonal.
      for (int j = first; j < last; j += 6) {
        const int top = std::max(r, j & ~7);
        if (top >= end) break;
        update_columns<Bytes>(c + static_cast<long>(j) * stride_c + top, stride_c, here + top, here + j,
                              stride, depth, end - top, std::min(6, last - j));
      }
    }
  }
}

template <int Bytes>
GLISSON_INLINE void update_block(double* panel, int stride, int first, int width, int from, int to) {
  subtract_lower<Bytes>(panel, stride, first, first + width, from, to, panel, stride, first);
}

template <int Bytes>
GLISSON_INLINE bool factor_block(double* panel, int stride, int first, int width, int to, double* inverse) {
  double l[kPanel][kPanel];
  const double* block = panel + static_cast<long>(first) * stride;
  for (int p = first; p < first + width; p += kPanel, inverse += kPanel) {
    const int n = std::min(kPanel, first + width - p);
    const int top = p & ~7;  // tiles start at multiples of 8: rows above the diagonal are scratch
    double* here = panel + static_cast<long>(p) * stride;
    if (p > first)
      update_columns<Bytes>(here + top, stride, block + top, block + p, stride, p - first, to - top, n);
    if (!small_cholesky(here + p, stride, n, l, inverse)) return false;
    // The triangle's own rows go through the same solve: what comes out is the triangle.
    solve_columns<Bytes>(here + top, stride, to - top, n, l, inverse);
  }
  return true;
}

template <int Bytes>
GLISSON_INLINE void solve_block(double* panel, int stride, int first, int width, int from, int to,
                                const double* inverse) {
  double l[kPanel][kPanel];
  const double* block = panel + static_cast<long>(first) * stride;
  for (int p = first; p < first + width; p += kPanel, inverse += kPanel) {
    const int n = std::min(kPanel, first + width - p);
    double* here = panel + static_cast<long>(p) * stride;
    if (p > first)
      update_columns<Bytes>(here + from, stride, block + from, block + p, stride, p - first, to - from, n);
    for (int j = 0; j < n; ++j)
      for (int i = j; i < n; ++i) l[i][j] = here[static_cast<long>(j) * stride + p + i];
    solve_columns<Bytes>(here + from, stride, to - from, n, l, inverse);
  }
}

template <int Bytes>
GLISSON_INLINE void subtract_product(double* schur, int stride_schur, int from, int to, const double* panel,
                                     int stride, int columns) {
  subtract_lower<Bytes>(schur, stride_schur, from, to, 0, stride_schur, panel + columns, stride, columns);
}

template <int Bytes>
GLISSON_INLINE void forward(const double* panel, int stride, int columns, int rows, double* x1, double* x2) {
  for (int j = 0; j < columns; ++j) {
    const double* column = panel + static_cast<long>(j) * stride;
    const double x = x1[j] / column[j];
    x1[j] = x;
    for (int i = j + 1; i < columns; ++i) x1[i] -= column[i] * x;
  }
  // Three columns at a time: fewer passes over x2.
  for (int j = 0; j < columns; j += 3) {
    const double* a = panel + static_cast<long>(j) * stride + columns;
    const double *b = a + stride, *c = b + stride;
    const double xa = x1[j], xb = x1[j + 1], xc = x1[j + 2];
    for (int i = 0; i < rows; ++i) x2[i] = ((x2[i] - a[i] * xa) - b[i] * xb) - c[i] * xc;
  }
}

template <int Bytes>
GLISSON_INLINE void backward(const double* panel, int stride, int columns, int rows, double* x1,
                             const double* x2) {
  using V = typename Vector<64>::type;  // eight partial sums on every machine: the same bits
  for (int j = columns - 1; j >= 0; --j) {
    const double* column = panel + static_cast<long>(j) * stride;
    const double* a = column + columns;
    V sums{};
    int i = 0;
    for (; i + 8 <= rows; i += 8) sums += at<64>(a + i).v * at<64>(x2 + i).v;
    double sum = 0.0;
    for (int k = 0; k < 8; ++k) sum += sums[k];
    for (; i < rows; ++i) sum += a[i] * x2[i];
    for (int k = j + 1; k < columns; ++k) sum += column[k] * x1[k];
    x1[j] = (x1[j] - sum) / column[j];
  }
}

/// M rows of y (kSolveWidth numbers each) -= the sum over k of factor(m, k) times row k of x; the factors of
/// row m begin at factors + m * step_m, step_k apart.
template <int Bytes, int M>
GLISSON_INLINE void subtract_rows(double* y, const double* x, const double* factors, long step_m, long step_k,
                                  int depth) {
  using V = typename Vector<Bytes>::type;
  constexpr int kLanes = Bytes / 8, kVectors = Bytes == 64 ? 4 : 2, kPiece = kVectors * kLanes;
  for (int piece = 0; piece < kSolveWidth; piece += kPiece) {
    V sum[M][kVectors];
#pragma GCC unroll 8
    for (int m = 0; m < M; ++m)
#pragma GCC unroll 8
      for (int v = 0; v < kVectors; ++v) sum[m][v] = at<Bytes>(y + m * kSolveWidth + piece + v * kLanes).v;
    const double *row = x + piece, *here = factors;
    for (int k = 0; k < depth; ++k, row += kSolveWidth, here += step_k) {
      V right[kVectors];
#pragma GCC unroll 8
      for (int v = 0; v < kVectors; ++v) right[v] = at<Bytes>(row + v * kLanes).v;
#pragma GCC unroll 8
      for (int m = 0; m < M; ++m) {
        const double factor = here[m * step_m];
#pragma GCC unroll 8
        for (int v = 0; v < kVectors; ++v) sum[m][v] -= right[v] * factor;
      }
    }
#pragma GCC unroll 8
    for (int m = 0; m < M; ++m)
#pragma GCC unroll 8
      for (int v = 0; v < kVectors; ++v) at<Bytes>(y + m * kSolveWidth + piece + v * kLanes).v = sum[m][v];
  }
}

/// Rows from `first` to `last`, in sixes and threes: both are multiples of 3.
template <int Bytes>
GLISSON_INLINE void subtract_all_rows(double* y, int first, int last, const double* x, const double* factors,
                                      long step_m, long step_k, int depth) {
  constexpr int kMost = Bytes == 64 ? 6 : 3;
  int i = first;
  for (; i + kMost <= last; i += kMost)
    subtract_rows<Bytes, kMost>(y + static_cast<long>(i) * kSolveWidth, x, factors + i * step_m, step_m,
                                step_k, depth);
  for (; i < last; i += 3)
    subtract_rows<Bytes, 3>(y + static_cast<long>(i) * kSolveWidth, x, factors + i * step_m, step_m, step_k,
                            depth);
}

template <int Bytes>
GLISSON_INLINE void forward_many(const double* panel, int stride, int columns, int rows, double* y) {
  for (int p = 0; p < columns; p += kPanel) {
    const int n = std::min(kPanel, columns - p);
    subtract_all_rows<Bytes>(y, p, p + n, y, panel, 1, stride, p);
    for (int j = p; j < p + n; ++j) {
      const double* column = panel + static_cast<long>(j) * stride;
      double* yj = y + static_cast<long>(j) * kSolveWidth;
      for (int l = p; l < j; ++l) {
        const double factor = panel[static_cast<long>(l) * stride + j];
        const double* yl = y + static_cast<long>(l) * kSolveWidth;
        for (int c = 0; c < kSolveWidth; ++c) yj[c] -= yl[c] * factor;
      }
      for (int c = 0; c < kSolveWidth; ++c) yj[c] /= column[j];
    }
  }
  subtract_all_rows<Bytes>(y, columns, columns + rows, y, panel, 1, stride, columns);
}

template <int Bytes>
GLISSON_INLINE void backward_many(const double* panel, int stride, int columns, int rows, double* y) {
  for (int p = (columns - 1) / kPanel * kPanel; p >= 0; p -= kPanel) {
    const int n = std::min(kPanel, columns - p), end = p + n;
    subtract_all_rows<Bytes>(y, p, end, y + static_cast<long>(end) * kSolveWidth, panel + end, stride, 1,
                             columns + rows - end);
    for (int j = end - 1; j >= p; --j) {
      const double* column = panel + static_cast<long>(j) * stride;
      double* yj = y + static_cast<long>(j) * kSolveWidth;
      for (int l = end - 1; l > j; --l) {
        const double factor = column[l];
        const double* yl = y + static_cast<long>(l) * kSolveWidth;
        for (int c = 0; c < kSolveWidth; ++c) yj[c] -= yl[c] * factor;
      }
      for (int c = 0; c < kSolveWidth; ++c) yj[c] /= column[j];
    }
  }
}

#define GLISSON_KERNELS(suffix, bytes, ...)                                                                \
  __VA_ARGS__ void update_block_##suffix(double* panel, int stride, int first, int width, int from,        \
                                         int to) {                                                         \
    update_block<bytes>(panel, stride, first, width, from, to);                                            \
  }                                                                                                        \
  __VA_ARGS__ bool factor_block_##suffix(double* panel, int stride, int first, int width, int to,          \
                                         double* inverse) {                                                \
    return factor_block<bytes>(panel, stride, first, width, to, inverse);                                  \
  }                                                                                                        \
  __VA_ARGS__ void solve_block_##suffix(double* panel, int stride, int first, int width, int from, int to, \
                                        const double* inverse) {                                           \
    solve_block<bytes>(panel, stride, first, width, from, to, inverse);                                    \
  }                                                                                                        \
  __VA_ARGS__ void subtract_product_##suffix(double* schur, int stride_schur, int from, int to,            \
                                             const double* panel, int stride, int columns) {               \
    subtract_product<bytes>(schur, stride_schur, from, to, panel, stride, columns);                        \
  }                                                                                                        \
  __VA_ARGS__ void forward_##suffix(const double* panel, int stride, int columns, int rows, double* x1,    \
                                    double* x2) {                                                          \
    forward<bytes>(panel, stride, columns, rows, x1, x2);                                                  \
  }                                                                                                        \
  __VA_ARGS__ void backward_##suffix(const double* panel, int stride, int columns, int rows, double* x1,   \
                                     const double* x2) {                                                   \
    backward<bytes>(panel, stride, columns, rows, x1, x2);                                                 \
  }                                                                                                        \
  __VA_ARGS__ void forward_many_##suffix(const double* panel, int stride, int columns, int rows,           \
                                         double* y) {                                                      \
    forward_many<bytes>(panel, stride, columns, rows, y);                                                  \
  }                                                                                                        \
  __VA_ARGS__ void backward_many_##suffix(const double* panel, int stride, int columns, int rows,          \
                                          double* y) {                                                     \
    backward_many<bytes>(panel, stride, columns, rows, y);                                                 \
  }                                                                                                        \
  constexpr DenseKernels kKernels_##suffix{                                                                \
      update_block_##suffix,     factor_block_##suffix,  solve_block_##suffix,                             \
      subtract_product_##suffix, forward_##suffix,       backward_##suffix,                                \
      forward_many_##suffix,     backward_many_##suffix, #suffix};

GLISSON_KERNELS(avx512, 64, __attribute__((target("avx512f"))))
GLISSON_KERNELS(avx2, 32, __attribute__((target("avx2"))))
GLISSON_KERNELS(sse2, 16, )

}  // namespace

std::vector<const DenseKernels*> available_dense_kernels() {
  std::vector<const DenseKernels*> kernels;
  if (__builtin_cpu_supports("avx512f")) kernels.push_back(&kKernels_avx512);
  if (__builtin_cpu_supports("avx2")) kernels.push_back(&kKernels_avx2);
  kernels.push_back(&kKernels_sse2);
  return kernels;
}

const DenseKernels& dense_kernels() { return *available_dense_kernels().front(); }

}  // namespace glisson::fem
