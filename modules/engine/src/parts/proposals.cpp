// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/parts/proposals.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "glisson/atlas/review.h"
#include "glisson/engine/parts/landmarks.h"
#include "glisson/engine/parts/model.h"
#include "review_step.h"
#include "transfer_file.h"

namespace glisson::engine {
namespace {
using atlas::Decision;
using atlas::Proposal;
using atlas::Source;
using atlas::Structure;
using atlas::Transfer;
using nlohmann::json;

constexpr const char* kFile = "atlas.json";

json save(const CaseState& state, const CaseFolder& folder) {
  write_transfer(folder.path / kFile, *state[part::proposals]);
  return json::object();
}

/// Somebody else's mesh: what holds it is told by fixed nodes.
bool is_bare(const PatientModel& model) {
  return std::none_of(model.surfaces.begin(), model.surfaces.end(),
                      [](const NamedSurface& surface) { return surface.name == "liver"; });
}

/// What registration knows by name.
constexpr std::array kUsed = {Structure::umbilical_notch, Structure::anterior_margin, Structure::vena_cava};

/// Proposed on this model, neither decided nor placed by hand.
bool waits(const CaseState& state, Structure structure) {
  const Proposal* one =
      stage_state(state, part::proposals) == StageState::current ? proposal_of(state, structure) : nullptr;
  return one != nullptr && one->decision == Decision::proposed && placed_points(state, structure).rows() == 0;
}

/// How many points of a landmark lie where the atlas alone has put them.
long from_statistics(const CaseState& state, Structure structure) {
  const Proposal* one = proposal_of(state, structure);
  if (one == nullptr || std::ranges::find(one->sources, Source::statistics) == one->sources.end()) return 0;
  const auto sources = proposed_sources(state, structure);
  return std::count(sources.begin(), sources.end(), Source::statistics);
}
bool is_statistics(const CaseState& state, Structure structure) {
  return from_statistics(state, structure) > 0;
}

std::string percent_of(long part, Eigen::Index all) {
  return std::to_string(100 * part / std::max<Eigen::Index>(1, all));
}

void add_margin_notes(const CaseState& state, std::vector<std::string>& notes) {
  const Proposal* margin = proposal_of(state, Structure::anterior_margin);
  const Eigen::Index used = placed_points(state, Structure::anterior_margin).rows();
  if (const long guessed = from_statistics(state, Structure::anterior_margin); guessed > 0)
    notes.push_back("atlas.margin_from_statistics " + percent_of(guessed, used));
  if (margin == nullptr || !landmark_is_as_reviewed(state, Structure::anterior_margin)) return;
  if (margin->decision != Decision::accepted && margin->decision != Decision::moved) return;
  const Eigen::Index left_out = margin->points.rows() - atlas::landmark_left_by(*margin).rows();
  if (left_out > 0) notes.push_back("atlas.margin_left_out " + percent_of(left_out, margin->points.rows()));
}

bool same(const CaseState& written, const CaseState& found) {
  return same_transfer(*written[part::proposals], *found[part::proposals]);
}

}  // namespace

const PartOf<Transfer> part::proposals{{.code = "proposals",
                                        .made_of = {part::model},
                                        .remedy = "Let the atlas propose the landmarks first",
                                        .files = {kFile},
                                        .save = save,
                                        .load =
                                            [](CaseState& state, const json&, const CaseFolder& folder) {
                                              state[part::proposals] = std::make_shared<const Transfer>(
                                                  read_transfer(folder.path / kFile));
                                            },
                                        .same = same,
                                        .is_input = false}};

const Proposal* proposal_of(const CaseState& state, atlas::Structure structure) {
  if (const auto& transfer = state[part::proposals])
    for (const Proposal& one : transfer->proposals)
      if (one.structure == structure) return &one;
  return nullptr;
}

LandmarkReview landmark_review(const CaseState& state) {
  LandmarkReview review;
  if (!state[part::model] || is_bare(state[part::model]->model)) return review;
  const auto any = [&](bool (*holds)(const CaseState&, Structure)) {
    return std::any_of(kUsed.begin(), kUsed.end(), [&](Structure one) { return holds(state, one); });
  };
  const bool nobody_was_asked = stage_state(state, part::proposals) != StageState::current &&
                                stage_state(state, part::landmarks) != StageState::current;
  review.is_open = nobody_was_asked || any(waits);
  review.from_statistics = any(is_statistics);
  return review;
}

std::vector<std::string> landmark_notes(const CaseState& state) {
  std::vector<std::string> notes;
  const Landmarks used = effective_landmarks(state);
  if (used.vena_cava.rows() == 0 && !is_bare(state[part::model]->model))
    notes.emplace_back("landmarks.no_vena_cava");
  const auto note = [&](const char* code, Structure structure) {
    if (!is_statistics(state, structure)) return;
    char text[64];
    std::snprintf(text, sizeof text, "%s %.1f", code, 1e3 * proposal_of(state, structure)->deviation());
    notes.emplace_back(text);
  };
  note("atlas.cava_from_statistics", Structure::vena_cava);
  note("atlas.notch_from_statistics", Structure::umbilical_notch);
  add_margin_notes(state, notes);
  for (const Structure one : kUsed)
    if (waits(state, one))
      notes.push_back(std::string("landmarks.not_reviewed ") + atlas::structure_code(one));
  return notes;
}

}  // namespace glisson::engine
