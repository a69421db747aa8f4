// SPDX-License-Identifier: GPL-3.0-or-later
#include "batch_kernels.h"

#include <Eigen/Core>

#include "polar.h"
#include "unaligned_vector.h"

namespace glisson::fem {
namespace {

using V = Vector<64>::type;
typedef long long Mask __attribute__((vector_size(64), may_alias));

GLISSON_INLINE void root(V& v) {
  for (int l = 0; l < kLanes; ++l) v[l] = __builtin_sqrt(v[l]);
}

GLISSON_INLINE void load(V& v, const double* source) { v = *reinterpret_cast<const V*>(source); }

/// The general decomposition, for lanes where Newton's iteration does not serve.
__attribute__((noinline)) void general_rotation(const V* f, V* q, int lane) {
  Eigen::Matrix3d m;
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) m(r, c) = f[3 * c + r][lane];
  const Eigen::Matrix3d rotation = polar_decomposition(m).rotation;
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) q[3 * c + r][lane] = rotation(r, c);
}

/// Rotations of eight matrices (columns x y z): q <- (q + q^-T) / 2 until nothing moves.
GLISSON_INLINE void rotations(const V* f, V* q) {
  V size{};
  for (int i = 0; i < 9; ++i) {
    q[i] = f[i];
    size += f[i] * f[i];
  }
  Mask done{}, bad{};
  for (int iteration = 0; iteration < 9; ++iteration) {
    V c[9];
    for (int k = 0; k < 3; ++k) {
      const V* a = q + 3 * ((k + 1) % 3);
      const V* b = q + 3 * ((k + 2) % 3);
      c[3 * k] = a[1] * b[2] - a[2] * b[1];
      c[3 * k + 1] = a[2] * b[0] - a[0] * b[2];
      c[3 * k + 2] = a[0] * b[1] - a[1] * b[0];
    }
    const V determinant = q[0] * c[0] + q[1] * c[1] + q[2] * c[2];
    // Inverted or nearly flat: this iteration would find a reflection or take long.
    if (iteration == 0)
      bad = ~((determinant > 0.0) & (determinant * determinant > 1e-6 * size * size * size));
    const V half = 0.5 / determinant;
    V change{};
    for (int i = 0; i < 9; ++i) {
      const V next = 0.5 * q[i] + half * c[i];
      change += (next - q[i]) * (next - q[i]);
      q[i] = next;
    }
    done = change < 1e-18;
    bool all = true;
    for (int l = 0; l < kLanes; ++l) all = all && (done[l] | bad[l]);
    if (all) break;
  }
  for (int l = 0; l < kLanes; ++l)
    if (!done[l] || bad[l]) general_rotation(f, q, l);
}

/// Adds the lanes of `entries` (9 a block, column-major) to the matrix.
template <int Blocks>
GLISSON_INLINE void scatter(const V* entries, const int (*slot)[kLanes], double* values) {
  const auto* lanes = reinterpret_cast<const double*>(entries);
  for (int l = 0; l < kLanes; ++l)
    for (int b = 0; b < Blocks; ++b) {
      double* target = values + 9L * slot[b][l];
      const double* source = lanes + static_cast<long>(9 * b) * kLanes + l;
      for (int e = 0; e < 9; ++e) target[e] += source[e * kLanes];
    }
}

template <int Nodes>
GLISSON_INLINE void gather(const int (*node)[kLanes], const double* x, V* edges) {
  auto* lanes = reinterpret_cast<double*>(edges);
  for (int l = 0; l < kLanes; ++l) {
    const double* origin = x + 3L * node[0][l];
    for (int k = 1; k < Nodes; ++k)
      for (int i = 0; i < 3; ++i) lanes[(3 * (k - 1) + i) * kLanes + l] = x[3L * node[k][l] + i] - origin[i];
  }
}

template <int Nodes>
GLISSON_INLINE void scatter_force(const V* pulls, const int (*node)[kLanes], double* force) {
  const auto* lanes = reinterpret_cast<const double*>(pulls);
  for (int l = 0; l < kLanes; ++l)
    for (int k = 0; k < Nodes; ++k)
      for (int i = 0; i < 3; ++i) force[3L * node[k][l] + i] -= lanes[(3 * k + i) * kLanes + l];
}

GLISSON_INLINE void tetrahedra(const TetrahedronGroup* groups, int count, double scale, const double* x,
                               double* values, double* force) {
  for (int n = 0; n < count; ++n) {
    const TetrahedronGroup& group = groups[n];
    V edges[9], g[9], f[9], q[9], lambda, mu;
    gather<4>(group.node, x, edges);
    for (int i = 0; i < 9; ++i) load(g[i], group.gradients[i]);
    for (int c = 0; c < 3; ++c)
      for (int r = 0; r < 3; ++r)
        f[3 * c + r] = edges[r] * g[c] + edges[3 + r] * g[3 + c] + edges[6 + r] * g[6 + c];
    rotations(f, q);
    load(lambda, group.lambda);
    load(mu, group.mu);
    // P = 2 mu (F - Q) + lambda (tr S - 3) Q, tr S = Q : F
    V trace{};
    for (int i = 0; i < 9; ++i) trace += q[i] * f[i];
    const V swelling = lambda * (trace - 3.0), twice = 2.0 * mu;
    V p[9], turned[12], pulls[12];
    for (int i = 0; i < 9; ++i) p[i] = twice * (f[i] - q[i]) + swelling * q[i];
    for (int r = 0; r < 3; ++r) {
      pulls[r] = V{};
      turned[r] = V{};
      for (int k = 0; k < 3; ++k) {
        pulls[3 * (k + 1) + r] = p[r] * g[3 * k] + p[3 + r] * g[3 * k + 1] + p[6 + r] * g[3 * k + 2];
        turned[3 * (k + 1) + r] = q[r] * g[3 * k] + q[3 + r] * g[3 * k + 1] + q[6 + r] * g[3 * k + 2];
        pulls[r] -= pulls[3 * (k + 1) + r];
        turned[r] -= turned[3 * (k + 1) + r];
      }
    }
    scatter_force<4>(pulls, group.node, force);
    V entries[90];
    int b = 0;
    const V first = scale * lambda, second = scale * mu;
    for (int i = 0; i < 4; ++i) {
      V li[3], mi[3];
      for (int r = 0; r < 3; ++r) {
        li[r] = first * turned[3 * i + r];
        mi[r] = second * turned[3 * i + r];
      }
      for (int j = 0; j <= i; ++j, ++b) {
        const V* gj = turned + 3 * j;
        V diagonal;
        load(diagonal, group.dots[b]);
        diagonal *= scale;
        for (int c = 0; c < 3; ++c)
          for (int r = 0; r < 3; ++r) {
            V entry = li[r] * gj[c] + gj[r] * mi[c];
            if (r == c) entry += diagonal;
            entries[9 * b + 3 * c + r] = entry;
          }
      }
    }
    scatter<10>(entries, group.slot, values);
  }
}

/// F (3 x 2, columns) = Q S by Cayley and Hamilton: S = (C + d I) / t, d = |f1 x f2|, t = sqrt(tr C + 2 d).
GLISSON_INLINE void plane_rotations(const V* f, V* q, V& trace_s) {
  const V c00 = f[0] * f[0] + f[1] * f[1] + f[2] * f[2], c11 = f[3] * f[3] + f[4] * f[4] + f[5] * f[5];
  const V c01 = f[0] * f[3] + f[1] * f[4] + f[2] * f[5];
  const V n0 = f[1] * f[5] - f[2] * f[4], n1 = f[2] * f[3] - f[0] * f[5], n2 = f[0] * f[4] - f[1] * f[3];
  V d = n0 * n0 + n1 * n1 + n2 * n2;
  root(d);
  V t = c00 + c11 + 2.0 * d;
  root(t);
  trace_s = t;  // tr S = (tr C + 2 d) / t
  const V scale = 1.0 / (t * d), s00 = (c00 + d) * scale, s11 = (c11 + d) * scale, s01 = c01 * scale;
  for (int r = 0; r < 3; ++r) {
    q[r] = f[r] * s11 - f[3 + r] * s01;
    q[3 + r] = f[3 + r] * s00 - f[r] * s01;
  }
  const Mask good = d > 1e-6 * (c00 + c11);
  for (int l = 0; l < kLanes; ++l) {
    if (good[l]) continue;
    Eigen::Matrix<double, 3, 2> m;
    for (int r = 0; r < 3; ++r) m.row(r) << f[r][l], f[3 + r][l];
    const PlanePolar polar = plane_polar_decomposition(m);
    trace_s[l] = polar.stretch.trace();
    for (int r = 0; r < 3; ++r) {
      q[r][l] = polar.rotation(r, 0);
      q[3 + r][l] = polar.rotation(r, 1);
    }
  }
}

GLISSON_INLINE void membranes(const MembraneGroup* groups, int count, double scale, const double* x,
                              double* values, double* force) {
  for (int n = 0; n < count; ++n) {
    const MembraneGroup& group = groups[n];
    V edges[6], g[4], f[6], q[6], lambda, mu, trace;
    gather<3>(group.node, x, edges);
    for (int i = 0; i < 4; ++i) load(g[i], group.gradients[i]);
    for (int c = 0; c < 2; ++c)
      for (int r = 0; r < 3; ++r) f[3 * c + r] = edges[r] * g[c] + edges[3 + r] * g[2 + c];
    plane_rotations(f, q, trace);
    load(lambda, group.lambda);
    load(mu, group.mu);
    const V swelling = lambda * (trace - 2.0), twice = 2.0 * mu;
    V p[6], turned[9], pulls[9], plane[9];
    for (int i = 0; i < 6; ++i) p[i] = twice * (f[i] - q[i]) + swelling * q[i];
    for (int r = 0; r < 3; ++r) {
      for (int k = 0; k < 2; ++k) {
        pulls[3 * (k + 1) + r] = p[r] * g[2 * k] + p[3 + r] * g[2 * k + 1];
        turned[3 * (k + 1) + r] = q[r] * g[2 * k] + q[3 + r] * g[2 * k + 1];
      }
      pulls[r] = -pulls[3 + r] - pulls[6 + r];
      turned[r] = -turned[3 + r] - turned[6 + r];
      for (int c = 0; c < 3; ++c) plane[3 * c + r] = q[r] * q[c] + q[3 + r] * q[3 + c];
    }
    scatter_force<3>(pulls, group.node, force);
    V entries[54];
    int b = 0;
    const V first = scale * lambda, second = scale * mu;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j <= i; ++j, ++b) {
        const V *gi = turned + 3 * i, *gj = turned + 3 * j;
        V dot;
        load(dot, group.dots[b]);
        dot *= scale;
        for (int c = 0; c < 3; ++c)
          for (int r = 0; r < 3; ++r)
            entries[9 * b + 3 * c + r] =
                first * gi[r] * gj[c] + second * gj[r] * gi[c] + dot * plane[3 * c + r];
      }
    scatter<6>(entries, group.slot, values);
  }
}

#define GLISSON_BATCH(suffix, ...)                                                                           \
  __VA_ARGS__ void tetrahedra_##suffix(const TetrahedronGroup* groups, int count, double scale,              \
                                       const double* x, double* values, double* force) {                     \
    tetrahedra(groups, count, scale, x, values, force);                                                      \
  }                                                                                                          \
  __VA_ARGS__ void membranes_##suffix(const MembraneGroup* groups, int count, double scale, const double* x, \
                                      double* values, double* force) {                                       \
    membranes(groups, count, scale, x, values, force);                                                       \
  }                                                                                                          \
  constexpr BatchKernels kBatch_##suffix{tetrahedra_##suffix, membranes_##suffix};

GLISSON_BATCH(avx512, __attribute__((target("avx512f"))))
GLISSON_BATCH(avx2, __attribute__((target("avx2"))))
GLISSON_BATCH(sse2, )

}  // namespace

std::vector<const BatchKernels*> available_batch_kernels() {
  std::vector<const BatchKernels*> kernels;
  if (__builtin_cpu_supports("avx512f")) kernels.push_back(&kBatch_avx512);
  if (__builtin_cpu_supports("avx2")) kernels.push_back(&kBatch_avx2);
  kernels.push_back(&kBatch_sse2);
  return kernels;
}

const BatchKernels& batch_kernels() { return *available_batch_kernels().front(); }

}  // namespace glisson::fem
