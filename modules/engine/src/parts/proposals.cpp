// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/parts/proposals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "case_files.h"
#include "glisson/atlas/review.h"
#include "glisson/core/error.h"
#include "glisson/core/json_file.h"
#include "glisson/engine/parts/landmarks.h"
#include "glisson/engine/parts/model.h"
#include "review_step.h"

namespace glisson::engine {
namespace {
using atlas::Decision;
using atlas::Proposal;
using atlas::Source;
using atlas::Structure;
using atlas::Transfer;
using nlohmann::json;

constexpr const char* kFile = "atlas.json";
constexpr double kSquareMillimetre = 1e-6;

json sheet_of(const Proposal& one) {
  json covariances = json::array(), sources = json::array();
  for (const Eigen::Matrix3d& c : one.covariances)
    covariances.push_back({c(0, 0) / kSquareMillimetre, c(0, 1) / kSquareMillimetre,
                           c(0, 2) / kSquareMillimetre, c(1, 1) / kSquareMillimetre,
                           c(1, 2) / kSquareMillimetre, c(2, 2) / kSquareMillimetre});
  for (const Source source : one.sources) sources.push_back(atlas::source_code(source));
  return {{"structure", atlas::structure_code(one.structure)},
          {"points", points_to_json(one.points)},
          {"covariances_mm2", covariances},
          {"sources", sources},
          {"area", points_to_json(one.area)},
          {"members", one.members},
          {"origin", one.origin},
          {"decision", atlas::decision_code(one.decision)}};
}

[[noreturn]] void refuse(const std::string& file, const std::string& field, const std::string& problem) {
  throw InputError(file, field, problem,
                   "Remove the file's entry from case.json and transfer the atlas again");
}

template <class Code, std::size_t N>
Code code_in(const char* (*code_of)(Code), const std::array<Code, N>& all, const json& text,
             const std::string& file, const char* field) {
  for (const Code one : all)
    if (text.is_string() && text.get<std::string>() == code_of(one)) return one;
  refuse(file, field, "is unknown");
}

Eigen::Matrix3d covariance_in(const json& row, const std::string& file) {
  if (!row.is_array() || row.size() != 6) refuse(file, "covariances_mm2", "needs six numbers a point");
  std::array<double, 6> c{};
  for (std::size_t i = 0; i < 6; ++i) {
    if (!row[i].is_number()) refuse(file, "covariances_mm2", "holds something else than numbers");
    c[i] = kSquareMillimetre * row[i].get<double>();
  }
  Eigen::Matrix3d matrix;
  matrix << c[0], c[1], c[2], c[1], c[3], c[4], c[2], c[4], c[5];
  if (!(matrix.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff() > 0.0))
    refuse(file, "covariances_mm2", "holds a matrix that is no covariance");
  return matrix;
}

Proposal proposal_in(const json& sheet, const std::string& file) {
  constexpr std::array kSources = {Source::statistics, Source::image, Source::both, Source::person};
  constexpr std::array kDecisions = {Decision::proposed, Decision::accepted, Decision::moved,
                                     Decision::not_visible};
  Proposal one;
  one.structure =
      code_in(atlas::structure_code, atlas::kStructures, sheet.at("structure"), file, "structure");
  one.points = points_from_json(sheet.at("points"), file, "points");
  for (const json& row : sheet.at("covariances_mm2")) one.covariances.push_back(covariance_in(row, file));
  for (const json& row : sheet.at("sources"))
    one.sources.push_back(code_in(atlas::source_code, kSources, row, file, "sources"));
  if (one.points.rows() != atlas::point_count(one.structure))
    refuse(file, "points", "are not as many as the structure has");
  const auto count = static_cast<std::size_t>(one.points.rows());
  if (one.covariances.size() != count || one.sources.size() != count)
    refuse(file, "points", "are not as many as covariances and sources");
  if (!sheet.at("area").empty()) one.area = points_from_json(sheet.at("area"), file, "area");
  // Atlases without shares have left contacts of nothing, which could never become a landmark.
  if (one.area.rows() == 0 && atlas::is_area(one.structure)) one.area = one.points;
  one.members = sheet.at("members").get<int>();
  one.origin = sheet.at("origin").get<std::string>();
  one.decision = code_in(atlas::decision_code, kDecisions, sheet.at("decision"), file, "decision");
  return one;
}

json save(const CaseState& state, const CaseFolder& folder) {
  const Transfer& transfer = *state[part::proposals];
  json proposals = json::array();
  for (const Proposal& one : transfer.proposals) proposals.push_back(sheet_of(one));
  json modes = json::array();
  for (const double b : transfer.modes) modes.push_back(b);
  write_json(folder.path / kFile, {{"frame", "LPS"},
                                   {"unit", "mm"},
                                   {"atlas", transfer.atlas},
                                   {"surface", points_to_json(transfer.surface)},
                                   {"mean_distance_mm", 1e3 * transfer.mean_distance},
                                   {"max_distance_mm", 1e3 * transfer.max_distance},
                                   {"modes", modes},
                                   {"unusual", transfer.unusual},
                                   {"doubts", transfer.doubts},
                                   {"proposals", proposals}});
  return json::object();
}

Transfer read(const std::filesystem::path& path) {
  const json sheet = read_json(path);
  const std::string file = path.string();
  Transfer transfer;
  try {
    transfer.atlas = sheet.at("atlas").get<std::string>();
    transfer.surface = points_from_json(sheet.at("surface"), file, "surface");
    transfer.mean_distance = 1e-3 * sheet.at("mean_distance_mm").get<double>();
    transfer.max_distance = 1e-3 * sheet.at("max_distance_mm").get<double>();
    const auto modes = sheet.at("modes").get<std::vector<double>>();
    transfer.modes = Eigen::Map<const Eigen::VectorXd>(modes.data(), static_cast<Eigen::Index>(modes.size()));
    transfer.unusual = sheet.at("unusual").get<double>();
    transfer.doubts = sheet.at("doubts").get<std::vector<std::string>>();
    std::set<Structure> known;
    for (const json& one : sheet.at("proposals")) {
      transfer.proposals.push_back(proposal_in(one, file));
      if (!known.insert(transfer.proposals.back().structure).second)
        refuse(file, "proposals", "name a structure twice");
    }
    if (known.empty()) refuse(file, "proposals", "are none");
  } catch (const json::exception& error) {
    refuse(file, "", std::string("is malformed (") + error.what() + ")");
  }
  return transfer;
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

/// But for what millimetres in text round.
bool same_number(double a, double b) { return std::abs(a - b) <= 1e-9 * std::max(std::abs(a), std::abs(b)); }

bool same_proposal(const Proposal& a, const Proposal& b) {
  const auto same_spread = [](const Eigen::Matrix3d& c, const Eigen::Matrix3d& d) {
    return (c - d).norm() <= 1e-9 * c.norm();
  };
  return a.structure == b.structure && a.decision == b.decision && a.sources == b.sources &&
         a.members == b.members && a.origin == b.origin && same_points(a.points, b.points) &&
         same_points(a.area, b.area) &&
         std::equal(a.covariances.begin(), a.covariances.end(), b.covariances.begin(), b.covariances.end(),
                    same_spread);
}

bool same(const CaseState& written, const CaseState& found) {
  const Transfer &a = *written[part::proposals], &b = *found[part::proposals];
  return a.atlas == b.atlas && a.doubts == b.doubts && same_points(a.surface, b.surface) &&
         same_number(a.mean_distance, b.mean_distance) && same_number(a.max_distance, b.max_distance) &&
         same_number(a.unusual, b.unusual) &&
         std::equal(a.modes.begin(), a.modes.end(), b.modes.begin(), b.modes.end(), same_number) &&
         std::equal(a.proposals.begin(), a.proposals.end(), b.proposals.begin(), b.proposals.end(),
                    same_proposal);
}

}  // namespace

const PartOf<Transfer> part::proposals{{.code = "proposals",
                                        .made_of = {part::model},
                                        .remedy = "Let the atlas propose the landmarks first",
                                        .files = {kFile},
                                        .save = save,
                                        .load =
                                            [](CaseState& state, const json&, const CaseFolder& folder) {
                                              state[part::proposals] =
                                                  std::make_shared<const Transfer>(read(folder.path / kFile));
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
