// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/case_state.h"

#include <utility>

#include "glisson/core/error.h"

namespace glisson::engine {
namespace {

/// Calls `visitor` with the same member of each of the states given.
template <class Visitor, class... State>
auto visit_part(Part part, Visitor&& visitor, State&&... states) {
  switch (part) {
    case Part::image:
      return visitor(states.image...);
    case Part::seeds:
      return visitor(states.seeds...);
    case Part::labels:
      return visitor(states.labels...);
    case Part::review:
      return visitor(states.review...);
    case Part::preview:
      return visitor(states.preview...);
    case Part::model:
      return visitor(states.model...);
    case Part::check:
      return visitor(states.check...);
    case Part::landmarks:
      return visitor(states.landmarks...);
    case Part::rig:
      return visitor(states.rig...);
    case Part::video:
      return visitor(states.video...);
    case Part::frame:
      return visitor(states.frame...);
    case Part::regions:
      return visitor(states.regions...);
    case Part::cloud:
      return visitor(states.cloud...);
    case Part::registration:
      return visitor(states.registration...);
    case Part::live:
      break;
  }
  return visitor(states.live...);
}

}  // namespace

std::string_view part_code(Part part) {
  static constexpr std::array<std::string_view, kPartCount> kCodes = {
      "image", "seeds", "labels", "review",  "preview", "model",        "check", "landmarks",
      "rig",   "video", "frame",  "regions", "cloud",   "registration", "live"};
  return kCodes[static_cast<std::size_t>(part)];
}

bool CaseState::has(Part part) const {
  return visit_part(
      part, [](const auto& value) { return value != nullptr; }, *this);
}

void CaseState::take(Part part, const CaseState& from) {
  visit_part(
      part, [](auto& mine, const auto& theirs) { mine = theirs; }, *this, from);
  if (part == Part::labels) {
    history = from.history;
    statistics = from.statistics;
  }
  if (part == Part::cloud) points = from.points;
  if (part == Part::registration) operations = from.operations;
}

bool CaseState::shares(Part part, const CaseState& with) const {
  return visit_part(
      part, [](const auto& mine, const auto& theirs) { return mine == theirs; }, *this, with);
}

std::vector<LabelInfo> reviewed_infos(const CaseState& state) {
  require(state.labels != nullptr, "labels that are named are there");
  std::vector<LabelInfo> infos = state.labels->infos;
  if (state.review)
    for (LabelInfo& info : infos)
      if (const auto known = state.review->find(info.code); known != state.review->end())
        info.status = slicer_status(known->second);
  return infos;
}

Editions editions(const CaseState& state) {
  Editions all{};
  for (int i = 0; i < kPartCount; ++i) {
    const Part part = static_cast<Part>(i);
    if (part != Part::live && part != Part::preview)
      all[static_cast<std::size_t>(i)] = state.stamp(part).revision;
  }
  return all;
}

StageState stage_state(const CaseState& state, Part part) {
  if (!state.has(part)) return StageState::absent;
  for (const auto& [input, revision] : state.stamp(part).made_from)
    if (state.stamp(input).revision != revision || stage_state(state, input) == StageState::stale)
      return StageState::stale;
  return StageState::current;
}

bool is_model_checked(const CaseState& state) {
  // Not stage_state(): what the model was made from may have gone on, the model is still the one looked at.
  if (!state.check || !state.check->is_right || !state.model) return false;
  const auto of = state.stamp(Part::check).made_from.find(Part::model);
  return of != state.stamp(Part::check).made_from.end() && of->second == state.stamp(Part::model).revision;
}

Landmarks effective_landmarks(const CaseState& state) {
  require(state.model != nullptr, "landmarks belong to a model");
  Landmarks landmarks = state.model->model.landmarks;
  if (state.landmarks) {
    if (state.landmarks->anterior_margin.rows() > 0)
      landmarks.anterior_margin = state.landmarks->anterior_margin;
    if (state.landmarks->umbilical_notch.rows() > 0)
      landmarks.umbilical_notch = state.landmarks->umbilical_notch;
    if (state.landmarks->vena_cava.rows() > 0) landmarks.vena_cava = state.landmarks->vena_cava;
  }
  return landmarks;
}

PatientModel effective_model(const CaseState& state) {
  PatientModel model = state.model->model;
  model.landmarks = effective_landmarks(state);
  return model;
}

}  // namespace glisson::engine
