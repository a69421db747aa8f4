// SPDX-License-Identifier: GPL-3.0-or-later
#include "beam.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "glisson/core/error.h"

namespace glisson::fem {
namespace {

Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return m;
}

/// The rotation vector of a rotation by less than 180 degrees.
Eigen::Vector3d rotation_vector(const Eigen::Matrix3d& r) {
  const Eigen::Quaterniond q(r);
  const double sine = q.vec().norm();
  // atan2 keeps small angles exact, where acos of the trace loses half the digits.
  if (sine < 1e-12) return 2.0 / q.w() * q.vec();
  const double w = q.w() < 0.0 ? -q.w() : q.w();
  const double sign = q.w() < 0.0 ? -1.0 : 1.0;
  return sign * 2.0 * std::atan2(sine, w) / sine * q.vec();
}

Eigen::Matrix3d rotation_of(const Eigen::Vector3d& v) {
  const double angle = v.norm();
  if (angle < 1e-300) return Eigen::Matrix3d::Identity();
  return Eigen::AngleAxisd(angle, v / angle).toRotationMatrix();
}

/// Change of D(psi) u with psi, D the logarithm's derivative in the mean frame (see kinematics()).
Eigen::Vector3d logarithm_rate(const Eigen::Vector3d& psi, const Eigen::Vector3d& change,
                               const Eigen::Vector3d& u) {
  const double angle = psi.norm();
  if (angle < 1e-3) return (2.0 * psi.dot(change) * u - change * psi.dot(u) - psi * change.dot(u)) / 24.0;
  const double half = 0.5 * angle, sine = std::sin(half), across = half / sine;
  const Eigen::Vector3d n = psi / angle;
  const double along = n.dot(change);
  const double slope = 0.5 * (sine - half * std::cos(half)) / (sine * sine);
  const Eigen::Vector3d dn = (change - n * along) / angle;
  return slope * along * (u - n * n.dot(u)) + (1.0 - across) * (dn * n.dot(u) + n * dn.dot(u));
}

}  // namespace

BeamSection BeamSection::hollow(double outer_radius, double wall, const Material& material) {
  require(outer_radius > 0.0 && wall > 0.0, "a beam has a positive radius and wall");
  const double inner = std::max(0.0, outer_radius - wall), nu = material.poisson_ratio;
  const double area = std::numbers::pi * (outer_radius * outer_radius - inner * inner);
  const double inertia = std::numbers::pi / 4.0 * (std::pow(outer_radius, 4) - std::pow(inner, 4));
  const double g = material.young_modulus / (2.0 * (1.0 + nu));
  const double m2 = (inner / outer_radius) * (inner / outer_radius), s = (1.0 + m2) * (1.0 + m2);
  const double kappa = 6.0 * (1.0 + nu) * s / ((7.0 + 6.0 * nu) * s + (20.0 + 12.0 * nu) * m2);
  return {material.young_modulus * area, material.young_modulus * inertia, g * 2.0 * inertia,
          kappa * g * area};
}

struct BeamElement::Kinematics {
  Eigen::Matrix3d mean;        ///< Rm
  Eigen::Vector3d chord;       ///< Rm^T (p2 - p1)
  Eigen::Vector3d gamma, psi;  ///< psi: the rotation vector between the nodes
  Eigen::Matrix3d d_psi;       ///< d psi = d_psi Rm^T (w2 - w1)
  Eigen::Matrix3d d_mean;      ///< Rm^T wm = (a1 + a2) / 2 - d_mean (a2 - a1), a_i = Rm^T w_i
};

BeamElement::BeamElement(const Eigen::Vector3d& rest_1, const Eigen::Vector3d& rest_2,
                         const BeamSection& section)
    : length_((rest_2 - rest_1).norm()) {
  require(length_ > 0.0, "a beam's nodes are apart");
  axis_ = (rest_2 - rest_1) / length_;
  const Eigen::Matrix3d along = axis_ * axis_.transpose();
  const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - along;
  const double shear = 1.0 / (1.0 / section.shear + length_ * length_ / (12.0 * section.bending));
  c_gamma_ = section.axial * along + shear * across;
  c_kappa_ = section.torsion * along + section.bending * across;
  sqrt_gamma_ = std::sqrt(length_) * (std::sqrt(section.axial) * along + std::sqrt(shear) * across);
  sqrt_kappa_ =
      std::sqrt(1.0 / length_) * (std::sqrt(section.torsion) * along + std::sqrt(section.bending) * across);
}

BeamElement::Kinematics BeamElement::kinematics(const BeamNodeState& a, const BeamNodeState& b) const {
  Kinematics k;
  k.psi = rotation_vector(a.rotation.transpose() * b.rotation);
  k.mean = a.rotation * rotation_of(0.5 * k.psi);
  k.chord = k.mean.transpose() * (b.position - a.position);
  k.gamma = k.chord / length_ - axis_;
  const double angle = k.psi.norm();
  // In the mean frame the logarithm's derivative is symmetric: 1 along psi, (t/2) / sin(t/2) across; the mean
  // frame itself turns by the mean spin less tan(t/4)/2 of psi's direction x (the spins' difference).
  const double half = 0.5 * angle;
  const double across = half < 1e-4 ? 1.0 + half * half / 6.0 : half / std::sin(half);
  const double quarter = angle < 1e-4 ? 0.25 : std::tan(0.25 * angle) / angle;
  if (angle > 1e-150) {
    const Eigen::Vector3d n = k.psi / angle;
    k.d_psi = across * Eigen::Matrix3d::Identity() + (1.0 - across) * n * n.transpose();
  } else {
    k.d_psi.setIdentity();
  }
  k.d_mean = 0.5 * quarter * cross_matrix(k.psi);
  return k;
}

double BeamElement::energy(const BeamNodeState& a, const BeamNodeState& b) const {
  const Kinematics k = kinematics(a, b);
  return 0.5 * length_ * k.gamma.dot(c_gamma_ * k.gamma) + 0.5 / length_ * k.psi.dot(c_kappa_ * k.psi);
}

BeamElement::Gradient BeamElement::gradient(const BeamNodeState& a, const BeamNodeState& b) const {
  return gradient_of(kinematics(a, b));
}

BeamElement::Rows BeamElement::stiffness_rows(const BeamNodeState& a, const BeamNodeState& b) const {
  return rows_of(kinematics(a, b));
}

void BeamElement::linearise(const BeamNodeState& a, const BeamNodeState& b, Gradient& gradient,
                            Rows& rows) const {
  const Kinematics k = kinematics(a, b);
  gradient = gradient_of(k);
  rows = rows_of(k);
}

BeamElement::Gradient BeamElement::gradient_of(const Kinematics& k) const {
  const Eigen::Vector3d n = c_gamma_ * k.gamma, m = k.d_psi * (c_kappa_ * k.psi) / length_;
  const Eigen::Vector3d q = n.cross(k.chord);
  const Eigen::Vector3d difference = m - k.d_mean.transpose() * q;
  Gradient g;
  g.segment<3>(6) = k.mean * n;
  g.segment<3>(0) = -g.segment<3>(6);
  g.segment<3>(3) = k.mean * (0.5 * q - difference);
  g.segment<3>(9) = k.mean * (0.5 * q + difference);
  return g;
}

BeamElement::Rows BeamElement::rows_of(const Kinematics& k) const {
  const Eigen::Matrix3d to_mean = k.mean.transpose();
  const Eigen::Matrix3d lever = cross_matrix(k.chord);  // d gamma L = Rm^T dd + chord x (Rm^T wm)
  Rows rows;
  rows.block<3, 3>(0, 6) = sqrt_gamma_ / length_ * to_mean;
  rows.block<3, 3>(0, 0) = -rows.block<3, 3>(0, 6);
  const Eigen::Matrix3d half = 0.5 * Eigen::Matrix3d::Identity();
  rows.block<3, 3>(0, 3) = sqrt_gamma_ / length_ * (lever * (half + k.d_mean)) * to_mean;
  rows.block<3, 3>(0, 9) = sqrt_gamma_ / length_ * (lever * (half - k.d_mean)) * to_mean;
  rows.block<3, 3>(3, 0).setZero();
  rows.block<3, 3>(3, 6).setZero();
  rows.block<3, 3>(3, 9) = sqrt_kappa_ * k.d_psi * to_mean;
  rows.block<3, 3>(3, 3) = -rows.block<3, 3>(3, 9);
  return rows;
}

Eigen::Matrix<double, 12, 12> BeamElement::gradient_rate(const BeamNodeState& a,
                                                         const BeamNodeState& b) const {
  const Kinematics k = kinematics(a, b);
  const Eigen::Vector3d n = c_gamma_ * k.gamma, couple = c_kappa_ * k.psi / length_;
  const Eigen::Vector3d q = n.cross(k.chord);
  const Eigen::Vector3d difference = k.d_psi * couple - k.d_mean.transpose() * q;
  const double angle = k.psi.norm();
  Eigen::Matrix<double, 12, 12> rate;
  for (int column = 0; column < 12; ++column) {
    Eigen::Matrix<double, 12, 1> move = Eigen::Matrix<double, 12, 1>::Zero();
    move[column] = 1.0;
    // Everything in the mean frame, which itself turns by `spin`.
    const Eigen::Vector3d apart = k.mean.transpose() * (move.segment<3>(6) - move.segment<3>(0));
    const Eigen::Vector3d first = k.mean.transpose() * move.segment<3>(3);
    const Eigen::Vector3d second = k.mean.transpose() * move.segment<3>(9);
    const Eigen::Vector3d spin = 0.5 * (first + second) - k.d_mean * (second - first);
    const Eigen::Vector3d psi = k.d_psi * (second - first);
    const Eigen::Vector3d chord = apart - spin.cross(k.chord);
    const Eigen::Vector3d dn = c_gamma_ * chord / length_;
    const Eigen::Vector3d dq = dn.cross(k.chord) + n.cross(chord);
    const Eigen::Vector3d dm = k.d_psi * (c_kappa_ * psi) / length_ + logarithm_rate(k.psi, psi, couple);
    // d_mean^T q = -tan(t/4) / (2 t) psi x q
    const double factor = angle < 1e-4 ? 0.25 : std::tan(0.25 * angle) / angle;
    const double slope =
        angle < 1e-3 ? angle / 96.0 : (0.25 / std::pow(std::cos(0.25 * angle), 2) - factor) / angle;
    const double turn = angle > 1e-150 ? slope * k.psi.dot(psi) / angle : 0.0;
    const Eigen::Vector3d d_shared =
        -0.5 * (turn * k.psi + factor * psi).cross(q) + k.d_mean.transpose() * dq;
    const Eigen::Vector3d d_difference = dm - d_shared;
    const Eigen::Vector3d force = k.mean * (dn + spin.cross(n));
    rate.col(column) << -force, k.mean * (0.5 * dq - d_difference + spin.cross(0.5 * q - difference)), force,
        k.mean * (0.5 * dq + d_difference + spin.cross(0.5 * q + difference));
  }
  return rate;
}

}  // namespace glisson::fem
