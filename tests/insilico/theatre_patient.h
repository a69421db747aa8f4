// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <numbers>

#include "glisson/patient/label_map.h"
#include "glisson/patient/patient_model.h"

/// A small patient whose liver is a formula: a half-moon that thins to an anterior inferior margin with a
/// notch in it, one lesion. Coarse and cheap; the synthetic patient has tests of its own.
namespace glisson::insilico::test {

inline Eigen::Vector3d liver_point(double theta, double phi) {
  // A sphere's point, stretched, thinned towards the left and towards the front and below, with a notch.
  const Eigen::Vector3d s(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
  Eigen::Vector3d p(0.105 * s.x(), 0.065 * s.y(), 0.070 * s.z());
  const double left = 0.5 + 0.5 * s.x();
  p.y() *= 1.0 - 0.45 * left;
  p.z() *= 1.0 - 0.35 * left;
  const double below = std::max(0.0, -s.z());
  p.y() = p.y() * (1.0 - 0.75 * below * below) - 0.035 * below * below;  // the wedge's edge lies in front
  p.z() += 0.018 * below * std::exp(-0.5 * std::pow((p.x() - 0.015) / 0.012, 2));
  return p;
}

inline TriangleMesh liver_surface(int rings) {
  const int around = 2 * rings;
  TriangleMesh mesh;
  mesh.vertices.resize(2 + (rings - 1) * around, 3);
  mesh.vertices.row(0) = liver_point(0.0, 0.0).transpose();
  mesh.vertices.row(mesh.vertices.rows() - 1) = liver_point(std::numbers::pi, 0.0).transpose();
  for (int r = 1; r < rings; ++r)
    for (int k = 0; k < around; ++k)
      mesh.vertices.row(1 + (r - 1) * around + k) =
          liver_point(std::numbers::pi * r / rings, 2.0 * std::numbers::pi * k / around).transpose();
  std::vector<Eigen::Vector3i> faces;
  const int last = mesh.vertex_count() - 1;
  for (int k = 0; k < around; ++k) {
    const int next = (k + 1) % around, bottom = 1 + (rings - 2) * around;
    faces.emplace_back(0, 1 + k, 1 + next);
    faces.emplace_back(last, bottom + next, bottom + k);
    for (int r = 0; r + 2 < rings; ++r) {
      const int a = 1 + r * around + k, b = 1 + r * around + next, c = a + around, d = b + around;
      faces.emplace_back(a, c, d);
      faces.emplace_back(a, d, b);
    }
  }
  mesh.triangles.resize(static_cast<Eigen::Index>(faces.size()), 3);
  for (std::size_t t = 0; t < faces.size(); ++t)
    mesh.triangles.row(static_cast<Eigen::Index>(t)) = faces[t].transpose();
  return mesh;
}

inline TriangleMesh ball(const Eigen::Vector3d& centre, double radius) {
  TriangleMesh mesh = liver_surface(10);
  const int around = 20;
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const bool top = v == 0, bottom = v == mesh.vertex_count() - 1;
    const double theta = top      ? 0.0
                         : bottom ? std::numbers::pi
                                  : std::numbers::pi * ((v - 1) / around + 1) / 10;
    const double phi = 2.0 * std::numbers::pi * ((v - 1) % around) / around;
    mesh.vertices.row(v) =
        (centre + radius * Eigen::Vector3d(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                                           std::cos(theta)))
            .transpose();
  }
  return mesh;
}

inline PatientModel small_patient() {
  PatientModel patient;
  patient.surfaces.push_back({structure::kParenchyma, "liver", liver_surface(36)});
  patient.surfaces.push_back({structure::kFirstLesion, "lesion_1", ball({-0.045, -0.002, 0.005}, 0.011)});
  // The edge: the lowest points for each place from right to left.
  Points margin(31, 3);
  for (int i = 0; i < 31; ++i) {
    const double x = -0.85 + 1.7 * i / 30.0;  // along the sphere's lowest half circle
    margin.row(i) =
        liver_point(std::numbers::pi - std::asin(std::abs(x)), x < 0 ? std::numbers::pi : 0.0).transpose();
  }
  patient.landmarks.anterior_margin = margin;
  Eigen::Index notch = 0;
  (margin.col(0).array() - 0.015).abs().minCoeff(&notch);
  patient.landmarks.umbilical_notch = margin.row(notch);
  patient.landmarks.vena_cava.resize(1, 3);
  patient.landmarks.vena_cava.row(0) =
      liver_point(0.35 * std::numbers::pi, 0.5 * std::numbers::pi).transpose();
  return patient;
}

}  // namespace glisson::insilico::test
