// SPDX-License-Identifier: GPL-3.0-or-later
#include "live_stage.h"

#include "glisson/experiments/synthetic_model.h"
#include "glisson/insilico/theatre.h"
#include "glisson/model/build.h"

namespace glisson::experiments {
namespace {

/// @return false: cancelled.
bool film(const insilico::Theatre& theatre, Filmed& filmed, const RunContext& context) {
  for (int k = 0; k < theatre.frame_count(); ++k) {
    if (context.cancelled()) return false;
    filmed.film.push_back(theatre.render(k));
    filmed.targets.push_back(theatre.truth(k).targets_in_camera);
    context.progress((k + 1.0) / theatre.frame_count(), "prove.theatre");
  }
  return true;
}

}  // namespace

Cancellable<LiveStage> theatre_stage(std::uint64_t seed, int frames, const RunContext& context) {
  auto synthetic = synthetic_model(seed, context.part(0.0, 0.35));
  if (!synthetic) return std::nullopt;
  PatientModel shown;
  shown.surfaces = std::move(synthetic->patient.surfaces);
  shown.vessels = std::move(synthetic->patient.trees);
  shown.landmarks = std::move(synthetic->patient.landmarks);
  insilico::TheatreOptions theatre_options;
  theatre_options.seed = seed;
  theatre_options.frames = frames;
  auto theatre = insilico::Theatre::build(shown, theatre_options, context.part(0.35, 0.6));
  if (!theatre) return std::nullopt;
  LiveStage stage;
  stage.model = std::move(synthetic->model);
  stage.rig = (*theatre)->rig();
  if (!film(**theatre, stage.standing, context.part(0.6, 0.8))) return std::nullopt;
  (*theatre)->move_scope(insilico::ScopePath::in_a_hand());
  if (!film(**theatre, stage.held, context.part(0.8, 1.0))) return std::nullopt;
  stage.start = (*theatre)->carry(stage.model.mesh.vertices, 0);
  const auto& targets = (*theatre)->targets();
  stage.targets_in_model.resize(static_cast<Eigen::Index>(targets.size()), 3);
  for (std::size_t i = 0; i < targets.size(); ++i) {
    stage.targets_in_model.row(static_cast<Eigen::Index>(i)) = targets[i].centre_in_ct.transpose();
    stage.lesions.push_back(targets[i].structure);
  }
  return stage;
}

}  // namespace glisson::experiments
