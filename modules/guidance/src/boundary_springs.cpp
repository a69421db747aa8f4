// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/guidance/boundary_springs.h"

#include <numbers>

#include "node_place.h"

namespace glisson::guidance {
namespace {

/// Outer radius of the vena cava where it holds the liver, metres, and its wall's share of it.
constexpr double kCavaRadius = 12e-3, kWallShare = 0.1;

double wall_section(double radius) {
  const double inner = radius * (1.0 - kWallShare);
  return std::numbers::pi * (radius * radius - inner * inner);
}

}  // namespace

BoundarySprings::BoundarySprings(const PatientModel& model, const Points& start_in_camera,
                                 double young_modulus, double length, double tether) {
  if (young_modulus <= 0.0) return;
  const auto in_series = [&](double radius) {
    const double structure = young_modulus * wall_section(radius) / length;
    return structure * tether / (structure + tether);
  };
  const Points& cava = model.landmarks.vena_cava;
  if (cava.rows() > 0) {
    // All its points together are one tube.
    const double each = in_series(kCavaRadius) / static_cast<double>(cava.rows());
    attach(model, cava, std::vector<double>(static_cast<std::size_t>(cava.rows()), each), start_in_camera);
  }
  for (const VesselTree& tree : model.vessels) {
    if (tree.root < 0 || tree.root >= tree.nodes.rows()) continue;
    attach(model, tree.nodes.row(tree.root), {in_series(tree.radii[static_cast<std::size_t>(tree.root)])},
           start_in_camera);
  }
}

void BoundarySprings::attach(const PatientModel& model, const Points& places_in_ct,
                             const std::vector<double>& stiffness, const Points& start_in_camera) {
  const Binding binding = bind_points(model.mesh, places_in_ct);
  for (Eigen::Index i = 0; i < places_in_ct.rows(); ++i) {
    Spring spring{};
    for (std::size_t k = 0; k < 4; ++k) {
      const auto column = static_cast<Eigen::Index>(k);
      spring.nodes[k] = model.mesh.tetrahedra(binding.tetrahedron[static_cast<std::size_t>(i)], column);
      spring.weights[k] = binding.weights(i, column);
    }
    spring.stiffness = stiffness[static_cast<std::size_t>(i)];
    spring.anchor = place_of(spring.nodes, spring.weights, start_in_camera);
    springs_.push_back(spring);
  }
}

void BoundarySprings::move(const RigidMotion& motion) {
  for (Spring& spring : springs_) spring.anchor = motion.rotation * spring.anchor + motion.translation;
}

void BoundarySprings::shift(const Points& motions_in_camera) {
  for (Spring& spring : springs_) spring.anchor += place_of(spring.nodes, spring.weights, motions_in_camera);
}

void BoundarySprings::add(const Points& nodes_in_camera, std::vector<fem::AttachedLoad>& loads) const {
  for (const Spring& spring : springs_) {
    fem::AttachedLoad load;
    load.nodes = spring.nodes;
    load.weights = spring.weights;
    load.force = spring.stiffness * (spring.anchor - place_of(spring.nodes, spring.weights, nodes_in_camera));
    load.tangent = spring.stiffness * Eigen::Matrix3d::Identity();
    loads.push_back(load);
  }
}

}  // namespace glisson::guidance
