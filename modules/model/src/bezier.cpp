// SPDX-License-Identifier: GPL-3.0-or-later
#include "bezier.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "glisson/core/error.h"

namespace glisson::model {
namespace {

constexpr int kReparametrisations = 8;

/// Schneider's recursion on one list of points.
class Fitter {
 public:
  Fitter(const std::vector<Eigen::Vector3d>& points, double tolerance, double reach)
      : points_(points), tolerance_(tolerance), reach_(reach) {}

  CurveChain fit() {
    chain_.parameters.resize(points_.size());
    const int last = static_cast<int>(points_.size()) - 1;
    fit(0, last, direction(0, 0, last), direction(last, 0, last));
    return std::move(chain_);
  }

 private:
  Eigen::Vector3d point(int i) const { return points_[static_cast<std::size_t>(i)]; }

  /// Unit vector at an end of the list, pointing into it: along the list at the first point, against it at
  /// the last.
  Eigen::Vector3d direction(int at, int first, int last) const {
    const int step = at == last ? -1 : 1;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int i = at + step; i >= first && i <= last && (point(i) - point(at)).norm() <= reach_; i += step)
      sum += point(i) - point(at);
    if (sum.norm() < 1e-12) sum = point(at + step) - point(at);
    return sum.normalized();
  }

  /// Common tangent at a joint, pointing back to the first curve.
  Eigen::Vector3d joint_tangent(int at, int first, int last) const {
    Eigen::Vector3d back = Eigen::Vector3d::Zero(), forth = back;
    for (int i = at - 1; i >= first && (point(i) - point(at)).norm() <= reach_; --i)
      back = point(i) - point(at);
    for (int i = at + 1; i <= last && (point(i) - point(at)).norm() <= reach_; ++i)
      forth = point(i) - point(at);
    if (back.norm() < 1e-12) back = point(at - 1) - point(at);
    if (forth.norm() < 1e-12) forth = point(at + 1) - point(at);
    const Eigen::Vector3d tangent = back - forth;
    return tangent.norm() > 1e-12 ? tangent.normalized() : back.normalized();
  }

  std::vector<double> chord_lengths(int first, int last) const {
    std::vector<double> u{0.0};
    for (int i = first + 1; i <= last; ++i) u.push_back(u.back() + (point(i) - point(i - 1)).norm());
    for (double& value : u) value /= u.back();
    return u;
  }

  /// Least squares for the lengths of the two inner handles.
  CubicBezier solve(int first, int last, const std::vector<double>& u, const Eigen::Vector3d& start,
                    const Eigen::Vector3d& end) const {
    Eigen::Matrix2d c = Eigen::Matrix2d::Zero();
    Eigen::Vector2d x = Eigen::Vector2d::Zero();
    const Eigen::Vector3d a = point(first), b = point(last);
    for (int i = first; i <= last; ++i) {
      const double t = u[static_cast<std::size_t>(i - first)], s = 1.0 - t;
      const double b0 = s * s * s, b1 = 3 * t * s * s, b2 = 3 * t * t * s, b3 = t * t * t;
      const Eigen::Vector3d h0 = b1 * start, h1 = b2 * end, rest = point(i) - (b0 + b1) * a - (b2 + b3) * b;
      c(0, 0) += h0.dot(h0);
      c(0, 1) += h0.dot(h1);
      c(1, 1) += h1.dot(h1);
      x += Eigen::Vector2d(h0.dot(rest), h1.dot(rest));
    }
    c(1, 0) = c(0, 1);
    const double chord = (b - a).norm();
    Eigen::Vector2d handles = Eigen::Vector2d::Constant(chord / 3.0);
    if (std::abs(c.determinant()) > 1e-12 * c.squaredNorm()) handles = c.inverse() * x;
    // Wu and Barsky's heuristic where the system misbehaves.
    if (handles.minCoeff() < 1e-3 * chord || handles.maxCoeff() > 3.0 * chord)
      handles.setConstant(chord / 3.0);
    return {{a, a + handles[0] * start, b + handles[1] * end, b}};
  }

  void reparametrise(const CubicBezier& curve, int first, std::vector<double>& u) const {
    for (std::size_t i = 1; i + 1 < u.size(); ++i) {
      const Eigen::Vector3d miss = curve.at(u[i]) - point(first + static_cast<int>(i)),
                            d = curve.derivative(u[i]), dd = curve.second_derivative(u[i]);
      const double slope = d.dot(d) + miss.dot(dd);
      if (std::abs(slope) > 1e-12) u[i] = std::clamp(u[i] - miss.dot(d) / slope, 0.0, 1.0);
    }
    for (std::size_t i = 1; i < u.size(); ++i) u[i] = std::max(u[i], u[i - 1]);
  }

  double worst(const CubicBezier& curve, int first, int last, const std::vector<double>& u, int& at) const {
    double worst = 0.0;
    at = (first + last) / 2;
    if (last - first < 2) return 0.0;  // nothing to part
    for (int i = first + 1; i < last; ++i) {
      const double miss = (curve.at(u[static_cast<std::size_t>(i - first)]) - point(i)).norm();
      if (miss > worst) {
        worst = miss;
        at = i;
      }
    }
    // Nor may a curve swing out between two points.
    for (int i = first; i < last; ++i) {
      const auto k = static_cast<std::size_t>(i - first);
      const Eigen::Vector3d along = point(i + 1) - point(i), p = curve.at(0.5 * (u[k] + u[k + 1])) - point(i);
      const double squared = along.squaredNorm();
      const double t = squared > 0.0 ? std::clamp(p.dot(along) / squared, 0.0, 1.0) : 0.0;
      const double miss = (p - t * along).norm();
      if (miss > worst) {
        worst = miss;
        at = std::clamp(i + 1, first + 1, last - 1);
      }
    }
    return worst;
  }

  void keep(const CubicBezier& curve, int first, const std::vector<double>& u) {
    const int number = static_cast<int>(chain_.curves.size());
    chain_.curves.push_back(curve);
    for (std::size_t i = 0; i < u.size(); ++i)
      chain_.parameters[static_cast<std::size_t>(first) + i] = {number, u[i]};
  }

  void fit(int first, int last, const Eigen::Vector3d& start, const Eigen::Vector3d& end) {
    std::vector<double> u = chord_lengths(first, last);
    CubicBezier curve = solve(first, last, u, start, end);
    int split = 0;
    double miss = worst(curve, first, last, u, split);
    for (int pass = 0; pass < kReparametrisations && miss > tolerance_; ++pass) {
      reparametrise(curve, first, u);
      curve = solve(first, last, u, start, end);
      miss = worst(curve, first, last, u, split);
    }
    if (miss <= tolerance_ || last - first < 2) {
      keep(curve, first, u);
      return;
    }
    split = std::clamp(split, first + 1, last - 1);
    const Eigen::Vector3d tangent = joint_tangent(split, first, last);
    fit(first, split, start, tangent);
    fit(split, last, -tangent, end);
  }

  const std::vector<Eigen::Vector3d>& points_;
  double tolerance_, reach_;
  CurveChain chain_;
};

}  // namespace

Eigen::Vector3d CubicBezier::at(double t) const {
  const double s = 1.0 - t;
  return s * s * s * control[0] + 3 * t * s * s * control[1] + 3 * t * t * s * control[2] +
         t * t * t * control[3];
}

Eigen::Vector3d CubicBezier::derivative(double t) const {
  const double s = 1.0 - t;
  return 3 * (s * s * (control[1] - control[0]) + 2 * s * t * (control[2] - control[1]) +
              t * t * (control[3] - control[2]));
}

Eigen::Vector3d CubicBezier::second_derivative(double t) const {
  return 6 * ((1.0 - t) * (control[2] - 2 * control[1] + control[0]) +
              t * (control[3] - 2 * control[2] + control[1]));
}

double CubicBezier::curvature(double t) const {
  const Eigen::Vector3d d = derivative(t);
  const double speed = d.norm();
  return speed > 1e-12 ? d.cross(second_derivative(t)).norm() / (speed * speed * speed) : 0.0;
}

CurveChain fit_curves(const std::vector<Eigen::Vector3d>& points, double tolerance, double tangent_reach) {
  require(points.size() >= 2, "fit_curves needs two points at least");
  require(
      (points.front() - points[1]).norm() > 0.0 && (points.back() - points[points.size() - 2]).norm() > 0.0,
      "fit_curves needs distinct points at the ends");
  return Fitter(points, tolerance, tangent_reach).fit();
}

}  // namespace glisson::model
