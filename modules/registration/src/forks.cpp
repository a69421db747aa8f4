// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/registration/forks.h"

#include <algorithm>

#include "glisson/core/error.h"
#include "glisson/geometry/rigid.h"
#include "glisson/patient/label_map.h"

namespace glisson::registration {
namespace {

/// Nodes from which two beams and more go on.
void add_forks(const VesselTree& tree, std::vector<VesselFork>& forks) {
  std::vector<int> branches(static_cast<std::size_t>(tree.nodes.rows()), 0);
  for (const auto& beam : tree.beams)
    for (const int end : beam) ++branches[static_cast<std::size_t>(end)];
  for (std::size_t i = 0; i < branches.size(); ++i)
    if (branches[i] > 2 || (branches[i] == 2 && static_cast<int>(i) == tree.root))
      forks.push_back(
          {tree.structure, tree.radii[i], tree.nodes.row(static_cast<Eigen::Index>(i)).transpose()});
}

std::vector<VesselFork> largest(std::vector<VesselFork> forks, int most) {
  std::stable_sort(forks.begin(), forks.end(),
                   [](const VesselFork& a, const VesselFork& b) { return a.radius > b.radius; });
  std::vector<VesselFork> kept;
  for (const VesselFork& fork : forks) {
    if (static_cast<int>(kept.size()) == most) break;
    if (std::none_of(kept.begin(), kept.end(), [&](const VesselFork& other) {
          return (fork.place - other.place).norm() < kForksApart;
        }))
      kept.push_back(fork);
  }
  return kept;
}

}  // namespace

std::vector<VesselFork> largest_forks(const std::vector<VesselTree>& vessels, int most) {
  std::vector<VesselFork> all;
  for (const Label structure : {structure::kPortalVein, structure::kHepaticVeins}) {
    std::vector<VesselFork> forks;
    for (const VesselTree& tree : vessels)
      if (tree.structure == structure) add_forks(tree, forks);
    for (VesselFork& fork : largest(std::move(forks), most)) all.push_back(std::move(fork));
  }
  return all;
}

namespace {

Binding bound(const PatientModel& model, const std::vector<VesselFork>& forks) {
  Points places(static_cast<Eigen::Index>(forks.size()), 3);
  for (std::size_t i = 0; i < forks.size(); ++i)
    places.row(static_cast<Eigen::Index>(i)) = forks[i].place.transpose();
  return bind_points(model.mesh, places, false);  // at the hilum they may lie outside of the mesh
}

}  // namespace

std::vector<ForkSpread> forks_of(const PatientModel& model, const Registration& registration,
                                 const ErrorModel& error) {
  const std::vector<VesselFork> forks = largest_forks(model.vessels);
  std::vector<ForkSpread> spreads;
  if (forks.empty()) return spreads;
  const Binding binding = bound(model, forks);
  const Points found = binding.apply(model.mesh, registration.nodes_in_camera);
  const std::vector<Eigen::Matrix3d> covariances = error.covariances(model.mesh, binding);
  for (std::size_t i = 0; i < forks.size(); ++i) {
    const bool is_next = i > 0 && forks[i].tree == forks[i - 1].tree;
    spreads.push_back({forks[i].tree, is_next ? spreads.back().order + 1 : 1, forks[i].radius,
                       found.row(static_cast<Eigen::Index>(i)).transpose(), covariances[i]});
  }
  return spreads;
}

void turn_errors(Registration& registration, const Points& from_in_camera, const Points& to_in_camera) {
  require(from_in_camera.rows() == to_in_camera.rows(), "an organ that has moved has the nodes that it had");
  const Eigen::Matrix3d turn = fit_rigid_motion(from_in_camera, to_in_camera, {}).rotation;
  const auto turned = [&turn](const Eigen::Matrix3d& covariance) -> Eigen::Matrix3d {
    return turn * covariance * turn.transpose();
  };
  for (LesionSpread& lesion : registration.lesions) lesion.covariance = turned(lesion.covariance);
  for (ForkSpread& fork : registration.forks) fork.covariance = turned(fork.covariance);
  for (Eigen::Index i = 0; i < registration.covariances.rows(); ++i)
    registration.covariances.row(i) =
        symmetric_row(turned(symmetric_matrix(registration.covariances.row(i))));
}

Registration carried_to(const PatientModel& model, Registration registration, const Points& nodes_in_camera) {
  turn_errors(registration, registration.nodes_in_camera, nodes_in_camera);
  registration.rivals.clear();
  registration.looks.clear();
  registration.forces.clear();
  registration.nodes_in_camera = nodes_in_camera;
  registration.camera_from_ct = fit_rigid<CameraFrame, CtFrame>(model.mesh.vertices, nodes_in_camera);
  place_forks(model, registration);
  return registration;
}

void place_forks(const PatientModel& model, Registration& registration) {
  const std::vector<VesselFork> forks = largest_forks(model.vessels);
  if (forks.size() != registration.forks.size() || forks.empty()) return;
  const Points found = bound(model, forks).apply(model.mesh, registration.nodes_in_camera);
  for (std::size_t i = 0; i < forks.size(); ++i)
    registration.forks[i].centre = found.row(static_cast<Eigen::Index>(i)).transpose();
}

}  // namespace glisson::registration
