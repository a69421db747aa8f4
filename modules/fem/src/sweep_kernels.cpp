// SPDX-License-Identifier: GPL-3.0-or-later
#include "sweep_kernels.h"

#include <algorithm>

#include "unaligned_vector.h"

namespace glisson::fem {
namespace {

// A column of a block in one vector: its fourth lane belongs to the next column and is never used.
using V = Vector<32>::type;

GLISSON_INLINE const Vector<32>::Unaligned& column(const double* p) { return at<32>(p); }
GLISSON_INLINE Vector<32>::Unaligned& column(double* p) { return at<32>(p); }

/// Three numbers, each the sum of a vector's first three lanes, and a zero.
GLISSON_INLINE void sums(const V* m, V& result) {
  result = V{m[0][0], m[1][0], m[2][0], 0.0} + V{m[0][1], m[1][1], m[2][1], 0.0} +
           V{m[0][2], m[1][2], m[2][2], 0.0};
}

GLISSON_INLINE void forward(int n, const int* start, const int* rows, const double* blocks,
                            const double* inverse, double* r, double* x) {
  for (int c = 0; c < n; ++c) {
    const double *rc = r + 4L * c, *d = inverse + 12L * c;
    const V xc = column(d).v * rc[0] + column(d + 4).v * rc[1] + column(d + 8).v * rc[2];
    column(x + 4L * c).v = xc;
    const double x0 = xc[0], x1 = xc[1], x2 = xc[2];
    for (int k = start[c] + 1; k < start[c + 1]; ++k) {
      const double* b = blocks + 9L * k;
      column(r + 4L * rows[k]).v -= column(b).v * x0 + column(b + 3).v * x1 + column(b + 6).v * x2;
    }
  }
}

GLISSON_INLINE void upper(int n, const int* start, const int* rows, const double* blocks, const double* x,
                          double* y) {
  for (int c = 0; c < n; ++c) {
    V m[3] = {};
    for (int k = start[c] + 1; k < start[c + 1]; ++k) {
      const double* b = blocks + 9L * k;
      const V xr = column(x + 4L * rows[k]).v;
      m[0] -= column(b).v * xr;
      m[1] -= column(b + 3).v * xr;
      m[2] -= column(b + 6).v * xr;
    }
    V sum;
    sums(m, sum);
    column(y + 4L * c).v = sum;
  }
}

GLISSON_INLINE void subtract(int n, const int* start, const int* rows, const double* blocks, const double* x,
                             double* r) {
  for (int c = 0; c < n; ++c) {
    const double* diagonal = blocks + 9L * start[c];
    const V xc = column(x + 4L * c).v;
    const double x0 = xc[0], x1 = xc[1], x2 = xc[2];
    V m[3] = {column(diagonal).v * xc, column(diagonal + 3).v * xc, column(diagonal + 6).v * xc};
    for (int k = start[c] + 1; k < start[c + 1]; ++k) {
      const double* b = blocks + 9L * k;
      const V first = column(b).v, second = column(b + 3).v, third = column(b + 6).v,
              xr = column(x + 4L * rows[k]).v;
      m[0] += first * xr;
      m[1] += second * xr;
      m[2] += third * xr;
      column(r + 4L * rows[k]).v -= first * x0 + second * x1 + third * x2;
    }
    V sum;
    sums(m, sum);
    column(r + 4L * c).v -= sum;
  }
}

GLISSON_INLINE void backward(int n, const int* start, const int* rows, const double* blocks,
                             const double* inverse, const double* r, double* x, double* y) {
  for (int c = n - 1; c >= 0; --c) {
    V m[3] = {};
    for (int k = start[c] + 1; k < start[c + 1]; ++k) {
      const double* b = blocks + 9L * k;
      const V xr = column(x + 4L * rows[k]).v;
      m[0] += column(b).v * xr;
      m[1] += column(b + 3).v * xr;
      m[2] += column(b + 6).v * xr;
    }
    V rest;
    sums(m, rest);
    rest = column(r + 4L * c).v - rest;
    const double* d = inverse + 12L * c;
    const V xc = column(d).v * rest[0] + column(d + 4).v * rest[1] + column(d + 8).v * rest[2];
    column(x + 4L * c).v = xc;
    column(y + 4L * c).v = V{};
    const double x0 = xc[0], x1 = xc[1], x2 = xc[2];
    for (int k = start[c] + 1; k < start[c + 1]; ++k) {  // the same blocks, still in the cache
      const double* b = blocks + 9L * k;
      column(y + 4L * rows[k]).v += column(b).v * x0 + column(b + 3).v * x1 + column(b + 6).v * x2;
    }
  }
}

#define GLISSON_SWEEPS(suffix, ...)                                                                  \
  __VA_ARGS__ void forward_##suffix(int n, const int* start, const int* rows, const double* blocks,  \
                                    const double* inverse, double* r, double* x) {                   \
    forward(n, start, rows, blocks, inverse, r, x);                                                  \
  }                                                                                                  \
  __VA_ARGS__ void upper_##suffix(int n, const int* start, const int* rows, const double* blocks,    \
                                  const double* x, double* y) {                                      \
    upper(n, start, rows, blocks, x, y);                                                             \
  }                                                                                                  \
  __VA_ARGS__ void subtract_##suffix(int n, const int* start, const int* rows, const double* blocks, \
                                     const double* x, double* r) {                                   \
    subtract(n, start, rows, blocks, x, r);                                                          \
  }                                                                                                  \
  __VA_ARGS__ void backward_##suffix(int n, const int* start, const int* rows, const double* blocks, \
                                     const double* inverse, const double* r, double* x, double* y) { \
    backward(n, start, rows, blocks, inverse, r, x, y);                                              \
  }                                                                                                  \
  constexpr SweepKernels kSweeps_##suffix{forward_##suffix, upper_##suffix, subtract_##suffix,       \
                                          backward_##suffix};

GLISSON_SWEEPS(avx2, __attribute__((target("avx2"))))
GLISSON_SWEEPS(sse2, )

}  // namespace

std::vector<const SweepKernels*> available_sweep_kernels() {
  std::vector<const SweepKernels*> kernels;
  if (__builtin_cpu_supports("avx2")) kernels.push_back(&kSweeps_avx2);
  kernels.push_back(&kSweeps_sse2);
  return kernels;
}

const SweepKernels& sweep_kernels() { return *available_sweep_kernels().front(); }

}  // namespace glisson::fem
