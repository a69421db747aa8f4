// SPDX-License-Identifier: GPL-3.0-or-later
#include "external_loads.h"

#include <Eigen/Dense>
#include <string>

#include "glisson/core/error.h"

namespace glisson::fem {
namespace {

template <class Visit>
void for_each_pressed(const CompositeModel::Impl& model, const Loads& loads, const Visit& visit) {
  if (loads.pressure == 0.0) return;
  const auto nodes_of = [&](int t) {
    std::array<int, 3> nodes;
    for (int k = 0; k < 3; ++k)
      nodes[static_cast<std::size_t>(k)] =
          model.surface.node_of_vertex[static_cast<std::size_t>(model.surface.mesh.triangles(t, k))];
    return nodes;
  };
  if (loads.pressure_triangles.empty()) {
    for (int t = 0; t < model.surface.mesh.triangle_count(); ++t) visit(nodes_of(t));
  } else {
    for (const int t : loads.pressure_triangles) visit(nodes_of(t));
  }
}

/// The symmetric part of minus the pressure force's derivative, or the positive part of that. In blocks of
/// nodes that symmetric part is (p/12) [e_k - e_i]x, e the edge opposite to a node: it couples moves along
/// the normal with moves in the plane, so that its eigenvalues are plus and minus the singular values of that
/// coupling.
Eigen::Matrix<double, 9, 9> pressure_tangent(const Eigen::Matrix3d& corners, double pressure, bool project) {
  Eigen::Matrix3d opposite;
  for (int k = 0; k < 3; ++k) opposite.col(k) = corners.col((k + 2) % 3) - corners.col((k + 1) % 3);
  Eigen::Vector3d normal = opposite.col(0).cross(opposite.col(1));
  const double size = normal.norm();
  Eigen::Matrix<double, 9, 9> tangent = Eigen::Matrix<double, 9, 9>::Zero();
  if (size < 1e-300) return tangent;
  normal /= size;
  // Column i: what moving node i by one along the normal asks of the in-plane forces.
  Eigen::Matrix<double, 9, 3> coupling;
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < 3; ++i)
      coupling.block<3, 1>(3 * k, i) = pressure / 12.0 * (opposite.col(i) - opposite.col(k)).cross(normal);
  if (!project) {
    for (int k = 0; k < 3; ++k)
      for (int i = 0; i < 3; ++i) {
        const Eigen::Matrix3d block = coupling.block<3, 1>(3 * k, i) * normal.transpose();
        tangent.block<3, 3>(3 * k, 3 * i) += block;
        tangent.block<3, 3>(3 * i, 3 * k) += block.transpose();
      }
    return tangent;
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen;
  eigen.computeDirect(Eigen::Matrix3d(coupling.transpose() * coupling));
  const double largest = eigen.eigenvalues()[2];
  for (int m = 0; m < 3; ++m) {
    if (!(eigen.eigenvalues()[m] > 1e-12 * largest)) continue;
    const double sigma = std::sqrt(eigen.eigenvalues()[m]);
    const Eigen::Vector3d v = eigen.eigenvectors().col(m);
    Eigen::Matrix<double, 9, 1> mode = coupling * v / sigma;
    for (int i = 0; i < 3; ++i) mode.segment<3>(3 * i) += v[i] * normal;
    tangent.noalias() += 0.5 * sigma * mode * mode.transpose();
  }
  return tangent;
}

Eigen::Matrix3d corners_of(const std::array<int, 3>& nodes, const Points& x) {
  Eigen::Matrix3d corners;
  for (int k = 0; k < 3; ++k) corners.col(k) = x.row(nodes[static_cast<std::size_t>(k)]).transpose();
  return corners;
}

}  // namespace

void check_loads(const CompositeModel::Impl& model, const Loads& loads) {
  const std::string remedy = "Correct the load";
  if (!loads.gravity_change.allFinite() || !std::isfinite(loads.pressure))
    throw InputError("loads", "gravity or pressure", "is not finite", remedy);
  const int triangles = model.surface.mesh.triangle_count();
  for (const int t : loads.pressure_triangles)
    if (t < 0 || t >= triangles)
      throw InputError("loads", "pressure triangle " + std::to_string(t),
                       "is not one of the " + std::to_string(triangles) + " of the boundary surface", remedy);
  for (std::size_t k = 0; k < loads.attached.size(); ++k) {
    const AttachedLoad& load = loads.attached[k];
    for (std::size_t i = 0; i < 4; ++i)
      if (load.nodes[i] < -1 || load.nodes[i] >= model.mesh.vertex_count())
        throw InputError("loads", "attached load " + std::to_string(k),
                         "names node " + std::to_string(load.nodes[i]), remedy);
    if (!load.force.allFinite() || !load.tangent.allFinite())
      throw InputError("loads", "attached load " + std::to_string(k), "is not finite", remedy);
  }
  for (const PrescribedNode& moved : loads.prescribed)
    if (moved.node < 0 || moved.node >= model.mesh.vertex_count() || !moved.position.allFinite())
      throw InputError("loads", "prescribed node " + std::to_string(moved.node),
                       "is not a node of the mesh or its position not finite", remedy);
}

void add_external_force(const CompositeModel::Impl& model, const Loads& loads, const Points& x,
                        Points& force) {
  if (!loads.gravity_change.isZero(0.0)) force += model.lumped_mass * loads.gravity_change.transpose();
  for_each_pressed(model, loads, [&](const std::array<int, 3>& nodes) {
    const Eigen::Matrix3d c = corners_of(nodes, x);
    // A sixth of the edges' cross product is a third of the area along the normal.
    const Eigen::Vector3d share = -loads.pressure / 6.0 * (c.col(1) - c.col(0)).cross(c.col(2) - c.col(0));
    for (const int node : nodes) force.row(node) += share.transpose();
  });
  for (const AttachedLoad& load : loads.attached)
    for (std::size_t i = 0; i < 4; ++i)
      if (load.nodes[i] >= 0) force.row(load.nodes[i]) += load.weights[i] * load.force.transpose();
}

void add_external_tangent(const CompositeModel::Impl& model, const Loads& loads, const Points& x,
                          Tangent kind, BlockSystem& system) {
  for_each_pressed(model, loads, [&](const std::array<int, 3>& nodes) {
    const Eigen::Matrix<double, 9, 9> k =
        pressure_tangent(corners_of(nodes, x), loads.pressure, kind != Tangent::exact);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j <= i; ++j)
        system.add(nodes[static_cast<std::size_t>(i)], nodes[static_cast<std::size_t>(j)],
                   k.block<3, 3>(3 * i, 3 * j));
  });
  for (const AttachedLoad& load : loads.attached) {
    if (load.tangent.isZero(0.0)) continue;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j <= i; ++j) {
        if (load.nodes[i] < 0 || load.nodes[j] < 0) continue;
        const double weight = load.weights[i] * load.weights[j];
        if (weight != 0.0) system.add(load.nodes[i], load.nodes[j], weight * load.tangent);
      }
  }
}

void add_pressure_skew_product(const CompositeModel::Impl& model, const Loads& loads, const Points& x,
                               const Points& direction, Points& product) {
  for_each_pressed(model, loads, [&](const std::array<int, 3>& nodes) {
    const Eigen::Matrix3d c = corners_of(nodes, x), d = corners_of(nodes, direction);
    // Minus the force's derivative: every node of a triangle sees the same change of the normal.
    Eigen::Vector3d whole = Eigen::Vector3d::Zero();
    for (int i = 0; i < 3; ++i)
      whole += loads.pressure / 6.0 * d.col(i).cross(c.col((i + 1) % 3) - c.col((i + 2) % 3));
    const Eigen::Map<const Eigen::Matrix<double, 9, 1>> flat(d.data());
    const Eigen::Matrix<double, 9, 1> symmetric = pressure_tangent(c, loads.pressure, false) * flat;
    for (int k = 0; k < 3; ++k)
      product.row(nodes[static_cast<std::size_t>(k)]) += (whole - symmetric.segment<3>(3 * k)).transpose();
  });
}

}  // namespace glisson::fem
