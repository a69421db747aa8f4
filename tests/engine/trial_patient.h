// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTest>

#include <memory>

#include "../fem/block_mesh.h"
#include "glisson/engine/commands/import_mesh.h"
#include "glisson/engine/commands/start_trial.h"
#include "glisson/engine/engine.h"
#include "glisson/engine/parts/cloud.h"
#include "glisson/engine/parts/frame.h"
#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/landmarks.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/engine/parts/rig.h"
#include "glisson/engine/parts/seeds.h"

/// @file
/// A patient on whom loads are tried, and an engine that gives it.

namespace glisson::engine {

/// A block of 120 x 80 x 50 mm with a portal vein through it that enters on the left, tied to a vena cava
/// behind.
inline std::shared_ptr<const model::BuiltModel> patient() {
  auto built = std::make_shared<model::BuiltModel>();
  PatientModel& model = built->model;
  model.mesh = fem_test::block_mesh({6, 4, 3}, {0.12, 0.08, 0.05});
  model.mesh.labels.assign(static_cast<std::size_t>(model.mesh.tetrahedron_count()), structure::kParenchyma);
  model.surface = boundary_surface(model.mesh);
  model.vessels = {fem_test::straight_vessel({0.01, 0.041, 0.026}, {0.11, 0.039, 0.024}, 5, 4e-3)};
  model.landmarks.vena_cava.resize(4, 3);
  model.landmarks.vena_cava << 0.05, 0.08, 0.005, 0.07, 0.08, 0.02, 0.05, 0.08, 0.03, 0.07, 0.08, 0.045;
  return built;
}

/// The engine's only other command here gives it that patient; whatever it writes is new.
inline Cancellable<Applied> give_patient(const CaseState& state, const Command& command,
                                         const RunContext& context, const Services& services) {
  if (command.traits().live != LiveLane::none) return apply(state, command, context, services);
  Applied applied;
  applied.state = state;
  if (command.traits().writes.has(part::model)) applied.state[part::model] = patient();
  if (command.traits().writes.has(part::landmarks))
    applied.state[part::landmarks] = std::make_shared<Landmarks>();
  if (command.traits().writes.has(part::labels)) applied.state[part::labels] = std::make_shared<LabelMap>();
  if (command.traits().writes.has(part::image)) applied.state[part::image] = std::make_shared<Image>();
  if (command.traits().writes.has(part::rig)) applied.state[part::rig] = std::make_shared<StereoRig>();
  if (command.traits().writes.has(part::frame)) applied.state[part::frame] = std::make_shared<StereoInput>();
  if (command.traits().writes.has(part::cloud))
    applied.state[part::cloud] = std::make_shared<LabelledCloud>();
  if (command.traits().writes.has(part::registration))
    applied.state[part::registration] = std::make_shared<Registration>();
  if (command.traits().writes.has(part::seeds))
    applied.state[part::seeds] = std::make_shared<segmentation::Seeds>();
  return applied;
}

inline Engine::Options options(Runner runner) {
  Engine::Options made;
  made.runner = runner;
  made.apply = give_patient;
  made.trial_seconds = 0.0;  // tests do not wait
  return made;
}

inline void start(Engine& engine) {
  engine.wait(engine.post(ImportMesh{}));
  QCOMPARE(engine.wait(engine.post(StartTrial{})).status, Status::done);
  QVERIFY(engine.snapshot()->trial != nullptr);
}

inline TrialPull at(int triangle, const Eigen::Vector3d& target) {
  return {triangle, Eigen::Vector3d(0.2, 0.3, 0.5), target};
}

inline std::array<int, 3> corners(const PatientModel& model, int triangle) {
  std::array<int, 3> nodes{};
  for (int k = 0; k < 3; ++k)
    nodes[static_cast<std::size_t>(k)] =
        model.surface.node_of_vertex[static_cast<std::size_t>(model.surface.mesh.triangles(triangle, k))];
  return nodes;
}

/// The pull by which the front's far corner is drawn 20 mm forwards and 10 mm up.
inline TrialPull corner_pull(const PatientModel& model) {
  int best = -1;
  double furthest = -1.0;
  for (int t = 0; t < model.surface.mesh.triangle_count(); ++t) {
    double forward = 0.0;
    for (const int node : corners(model, t))
      forward += model.mesh.vertices(node, 0) - model.mesh.vertices(node, 1) + model.mesh.vertices(node, 2);
    if (forward > furthest) best = t, furthest = forward;
  }
  TrialPull pull = at(best, Eigen::Vector3d(0.0, -0.02, 0.01));
  for (std::size_t k = 0; k < 3; ++k)
    pull.target += pull.weights[static_cast<Eigen::Index>(k)] *
                   model.mesh.vertices.row(corners(model, best)[k]).transpose();
  return pull;
}

}  // namespace glisson::engine
