// SPDX-License-Identifier: GPL-3.0-or-later
#include "sweep_kernels.h"

#include <algorithm>

#define GLISSON_INLINE inline __attribute__((always_inline))

namespace glisson::fem {
namespace {

// A column of a block in one vector: its fourth lane belongs to the next column and is never used.
typedef double V __attribute__((vector_size(32), aligned(8), may_alias));

GLISSON_INLINE const V& at(const double* p) { return *reinterpret_cast<const V*>(p); }
GLISSON_INLINE V& at(double* p) { return *reinterpret_cast<V*>(p); }

/// Three numbers, each the sum of a vector's first three lanes, and a zero.
GLISSON_INLINE void sums(const V* m, V& result) {
  result = V{m[0][0], m[1][0], m[2][0], 0.0} + V{m[0][1], m[1][1], m[2][1], 0.0} +
           V{m[0][2], m[1][2], m[2][2], 0.0};
}

GLISSON_INLINE void forward(int n, const int* start, const int* rows, const double* blocks,
                            const double* inverse, double* r, double* x) {
  for (int c = 0; c < n; ++c) {
    const double *rc = r + 4L * c, *d = inverse + 12L * c;
    const V xc = at(d) * rc[0] + at(d + 4) * rc[1] + at(d + 8) * rc[2];
    at(x + 4L * c) = xc;
    const double x0 = xc[0], x1 = xc[1], x2 = xc[2];
    for (int k = start[c] + 1; k < start[c + 1]; ++k) {
      const double* b = blocks + 9L * k;
      at(r + 4L * rows[k]) -= at(b) * x0 + at(b + 3) * x1 + at(b + 6) * x2;
    }
  }
}

GLISSON_INLINE void upper(int n, const int* start, const int* rows, const double* blocks, const double* x,
                          double* y) {
  for (int c = 0; c < n; ++c) {
    V m[3] = {};
    for (int k = start[c] + 1; k < start[c + 1]; ++k) {
      const double* b = blocks + 9L * k;
      const V xr = at(x + 4L * rows[k]);
      m[0] -= at(b) * xr;
      m[1] -= at(b + 3) * xr;
      m[2] -= at(b + 6) * xr;
    }
    V sum;
    sums(m, sum);
    at(y + 4L * c) = sum;
  }
}

GLISSON_INLINE void subtract(int n, const int* start, const int* rows, const double* blocks, const double* x,
                             double* r) {
  for (int c = 0; c < n; ++c) {
    const double* diagonal = blocks + 9L * start[c];
    const V xc = at(x + 4L * c);
    const double x0 = xc[0], x1 = xc[1], x2 = xc[2];
    V m[3] = {at(diagonal) * xc, at(diagonal + 3) * xc, at(diagonal + 6) * xc};
    for (int k = start[c] + 1; k < start[c + 1]; ++k) {
      const double* b = blocks + 9L * k;
      const V first = at(b), second = at(b + 3), third = at(b + 6), xr = at(x + 4L * rows[k]);
      m[0] += first * xr;
      m[1] += second * xr;
      m[2] += third * xr;
      at(r + 4L * rows[k]) -= first * x0 + second * x1 + third * x2;
    }
    V sum;
    sums(m, sum);
    at(r + 4L * c) -= sum;
  }
}

GLISSON_INLINE void backward(int n, const int* start, const int* rows, const double* blocks,
                             const double* inverse, const double* r, double* x, double* y) {
  for (int c = n - 1; c >= 0; --c) {
    V m[3] = {};
    for (int k = start[c] + 1; k < start[c + 1]; ++k) {
      const double* b = blocks + 9L * k;
      const V xr = at(x + 4L * rows[k]);
      m[0] += at(b) * xr;
      m[1] += at(b + 3) * xr;
      m[2] += at(b + 6) * xr;
    }
    V rest;
    sums(m, rest);
    rest = at(r + 4L * c) - rest;
    const double* d = inverse + 12L * c;
    const V xc = at(d) * rest[0] + at(d + 4) * rest[1] + at(d + 8) * rest[2];
    at(x + 4L * c) = xc;
    at(y + 4L * c) = V{};
    const double x0 = xc[0], x1 = xc[1], x2 = xc[2];
    for (int k = start[c] + 1; k < start[c + 1]; ++k) {  // the same blocks, still in the cache
      const double* b = blocks + 9L * k;
      at(y + 4L * rows[k]) += at(b) * x0 + at(b + 3) * x1 + at(b + 6) * x2;
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
