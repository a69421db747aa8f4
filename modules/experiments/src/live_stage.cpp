// SPDX-License-Identifier: GPL-3.0-or-later
#include "live_stage.h"

#include <utility>

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
  const PatientModel shown = shown_in_theatre(std::move(synthetic->patient));
  insilico::TheatreOptions theatre_options;
  theatre_options.seed = seed;
  theatre_options.frames = frames;
  auto theatre = insilico::Theatre::build(shown, theatre_options, context.part(0.35, 0.6));
  if (!theatre) return std::nullopt;
  LiveStage stage;
  stage.model = std::move(synthetic->model);
  stage.rig = (*theatre)->rig();
  if (!film(**theatre, stage.standing, context.part(0.6, 0.68))) return std::nullopt;
  for (const auto& [use, filmed] : {std::pair{insilico::ToolUse::lifts(), &stage.tool_lifts},
                                    {insilico::ToolUse::presses(), &stage.tool_presses}}) {
    insilico::ToolUse seeded = use;
    seeded.seed = seed;
    if (!(*theatre)->use_tool(seeded, context.quiet()) || !film(**theatre, *filmed, context.part(0.68, 0.76)))
      return std::nullopt;
  }
  (*theatre)->use_tool({}, context.quiet());
  for (const auto& [path, filmed] : {std::pair{insilico::ScopePath::in_a_hand(), &stage.held},
                                     {insilico::ScopePath::in_a_fast_hand(), &stage.fast}}) {
    (*theatre)->move_scope(path);
    if (!film(**theatre, *filmed, context.part(0.84, 0.92))) return std::nullopt;
  }
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
