// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/core/error.h"
#include "glisson/fem/integrator.h"
#include "phantom.h"

namespace glisson::phantom {

/// A truth that the registration cannot meet itself in: a finer mesh, a Neo-Hookean law, other loads than
/// penalties (gas, turned gravity, a held cava, a soft bed), all in the CT's frame.
struct Truth {
  PatientModel body;
  Points nodes_in_ct;  ///< deformed

  /// Where points of the CT are in the deformed body.
  Points carry(const Points& points) const {
    return bind_points(body.mesh, points, false).apply(body.mesh, nodes_in_ct);
  }
};

/// @param level 1: about 8 mm remain after the best rigid alignment.
inline Truth deform(double level, int nx = 15, int ny = 11, int nz = 6) {
  Truth truth;
  truth.body = model(nx, ny, nz);
  fem::CompositeOptions materials;
  materials.law = fem::TetrahedronLaw::neo_hookean;
  const fem::CompositeModel composite(truth.body.mesh, {}, materials);
  const BoundarySurface& surface = composite.surface();
  const Points normals = vertex_normals(surface.mesh);
  const Points& rest = truth.body.mesh.vertices;
  const Eigen::VectorXd areas = triangle_areas(surface.mesh);
  Eigen::VectorXd node_area = Eigen::VectorXd::Zero(rest.rows());
  std::vector<int> dome;
  const Points faces = triangle_normals(surface.mesh);
  for (int t = 0; t < surface.mesh.triangle_count(); ++t) {
    if (faces(t, 2) > 0.35) dome.push_back(t);
    for (int k = 0; k < 3; ++k)
      node_area[surface.node_of_vertex[static_cast<std::size_t>(surface.mesh.triangles(t, k))]] +=
          areas[t] / 3.0;
  }
  const Points cava = truth.body.landmarks.vena_cava;
  const auto loads = [&](double share, const Points& x) {
    fem::Loads result;
    result.pressure = 900.0 * share;
    result.pressure_triangles = dome;
    result.gravity_change = share * Eigen::Vector3d(3.5, -4.0, 1.5);
    for (int v = 0; v < surface.mesh.vertex_count(); ++v) {
      const int node = surface.node_of_vertex[static_cast<std::size_t>(v)];
      const bool held = (cava.rowwise() - rest.row(node)).rowwise().norm().minCoeff() < 0.018;
      const bool bed = normals(v, 2) < -0.3;
      if (!held && !bed) continue;
      const double stiffness = (held ? 2e6 : 4e4) * node_area[node];
      fem::AttachedLoad load;
      load.nodes[0] = node;
      load.weights[0] = 1.0;
      load.force = stiffness * (rest.row(node) - x.row(node)).transpose();
      load.tangent = stiffness * Eigen::Matrix3d::Identity();
      result.attached.push_back(load);
    }
    return result;
  };
  truth.nodes_in_ct = rest;
  fem::StaticOptions options;
  options.tolerance = 1e-5;
  constexpr int kSteps = 4;
  for (int i = 1; i <= kSteps; ++i) {
    const auto summary = fem::solve_static(
        composite, truth.nodes_in_ct, [&](const Points& x) { return loads(level * i / kSteps, x); }, options,
        RunContext());
    if (!summary || !summary->converged) throw NumericalError("the phantom's truth has no equilibrium");
    truth.nodes_in_ct = summary->positions;
  }
  return truth;
}

}  // namespace glisson::phantom
