// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <utility>

#include "glisson/core/random.h"

/// @file
/// Implicit shapes: a field is negative inside, about the distance in millimetres near its surface, and never
/// steeper than kSteepest. This private corner of the module counts in LPS millimetres like the CT that it
/// draws (anatomy is quoted so); patient.cpp turns everything into metres on the way out.

namespace glisson::insilico {

using Vec = Eigen::Vector3d;

/// Bound on the slope of all fields here; lets a block far from a surface be skipped after one evaluation.
inline constexpr double kSteepest = 2.0;

/// Polynomial smooth maximum (Quilez): rounds the edge between two fields over about `k` mm.
inline double smooth_max(double a, double b, double k) {
  const double h = std::max(k - std::abs(a - b), 0.0) / k;
  return std::max(a, b) + 0.25 * h * h * k;
}
inline double smooth_min(double a, double b, double k) { return -smooth_max(-a, -b, k); }
inline double smooth_step(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}
/// About max(x, 0), with a bend of width s.
inline double soft_ramp(double x, double s) { return 0.5 * (x + std::sqrt(x * x + s * s)); }
inline double mix(double a, double b, double t) { return a + (b - a) * t; }
inline Vec mix_points(const Vec& a, const Vec& b, double t) { return a + (b - a) * t; }

/// std::hypot, which took a fifth of a patient's time, of lengths that neither overflow nor vanish.
inline double length(double x, double y) { return std::sqrt(x * x + y * y); }

/// First-order distance to the ellipsoid with semi-axes r about the origin (Quilez).
inline double ellipsoid(const Vec& p, const Vec& r) {
  const Vec q = p.cwiseQuotient(r);
  const double k0 = q.norm();
  const double k1 = q.cwiseQuotient(r).norm();
  return k1 < 1e-9 ? -r.minCoeff() : k0 * (k0 - 1.0) / k1;
}
/// The same for an elliptic cylinder along z.
inline double elliptic_cylinder(double x, double y, double rx, double ry) {
  const double qx = x / rx, qy = y / ry;
  const double k0 = length(qx, qy);
  const double k1 = length(qx / rx, qy / ry);
  return k1 < 1e-9 ? -std::min(rx, ry) : k0 * (k0 - 1.0) / k1;
}

/// A ball that grows or shrinks while it moves from a to b.
struct RoundCone {
  Vec a, b;
  double ra, rb;

  double operator()(const Vec& p) const {
    const Vec d = b - a;
    const double t = std::clamp((p - a).dot(d) / std::max(d.squaredNorm(), 1e-12), 0.0, 1.0);
    return (p - a - t * d).norm() - mix(ra, rb, t);
  }
};

/// Uniform numbers that are the same with every standard library.
class Dice {
 public:
  explicit Dice(const std::mt19937_64& source) : source_(source) {}
  double between(double low, double high) { return low + (high - low) * uniform01(source_); }
  Vec inside(const Vec& low, const Vec& high) {
    const double x = between(low.x(), high.x());
    const double y = between(low.y(), high.y());
    return {x, y, between(low.z(), high.z())};
  }

 private:
  std::mt19937_64 source_;
};

/// A cheap hash of a counter (splitmix64), for noise that does not depend on the order of evaluation.
inline std::uint64_t hash_of(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ULL;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

}  // namespace glisson::insilico
