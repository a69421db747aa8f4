// SPDX-License-Identifier: GPL-3.0-or-later
#include "review_step.h"

#include <algorithm>
#include <string>
#include <utility>

#include "glisson/atlas/review.h"
#include "glisson/core/error.h"
#include "glisson/engine/commands/propose_landmarks.h"
#include "glisson/engine/landmark_origin.h"
#include "glisson/engine/parts/landmarks.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/proposals.h"

namespace glisson::engine {
namespace {

constexpr double kSame = 1e-6;  // metres, between points that files have rounded

Points* points_of(Landmarks& landmarks, atlas::Structure structure) {
  if (structure == atlas::Structure::umbilical_notch) return &landmarks.umbilical_notch;
  if (structure == atlas::Structure::anterior_margin) return &landmarks.anterior_margin;
  if (structure == atlas::Structure::vena_cava) return &landmarks.vena_cava;
  return nullptr;
}

/// Those that are of this model. Empty: none.
Landmarks placed(const CaseState& state) {
  const auto& landmarks = state[part::landmarks];
  return landmarks && stage_state(state, part::landmarks) == StageState::current ? *landmarks : Landmarks{};
}

/// With these points as a structure's landmark, where registration knows it. @param deviations of the points,
/// metres; none: 0
CaseState with_landmark(CaseState state, atlas::Structure structure, const Points& landmark,
                        const Eigen::VectorXd& deviations) {
  Landmarks landmarks = placed(state);
  Points* points = points_of(landmarks, structure);
  if (points == nullptr) return state;
  *points = landmark;
  if (structure == atlas::Structure::anterior_margin) {
    require(deviations.size() == 0 || deviations.size() == landmark.rows(),
            "there are as many deviations of a margin as points");
    landmarks.margin_deviation = deviations;
  }
  if (structure == atlas::Structure::umbilical_notch)
    landmarks.notch_deviation = deviations.size() > 0 ? deviations.maxCoeff() : 0.0;
  const bool none = landmarks.empty() && landmarks.vena_cava.rows() == 0;
  state[part::landmarks] = none ? nullptr : std::make_shared<const Landmarks>(std::move(landmarks));
  return state;
}

}  // namespace

Points placed_points(const CaseState& state, atlas::Structure structure) {
  Landmarks landmarks = placed(state);
  const Points* points = points_of(landmarks, structure);
  return points == nullptr ? Points(0, 3) : *points;
}

Eigen::VectorXd placed_deviations(const CaseState& state, atlas::Structure structure) {
  const Landmarks landmarks = placed(state);
  if (structure == atlas::Structure::anterior_margin) return landmarks.margin_deviation;
  if (structure != atlas::Structure::umbilical_notch || landmarks.umbilical_notch.rows() == 0) return {};
  return Eigen::VectorXd::Constant(1, landmarks.notch_deviation);
}

CommandTraits review_traits(std::string_view code) {
  return {.code = code,
          .reads = {part::model},  // a later step makes neither part out of date
          .writes = {part::proposals, part::landmarks},
          .needs = {part::model, part::proposals},
          .current = {part::proposals},
          .lane = Lane::edits,
          .notice = Notice::quiet};
}

const atlas::Proposal& require_proposed(const CaseState& state, atlas::Structure structure) {
  const atlas::Proposal* proposal = proposal_of(state, structure);
  if (proposal == nullptr)
    throw InputError("review", atlas::structure_code(structure), "is not proposed",
                     "Let an atlas that knows it propose it first");
  return *proposal;
}

Applied with_review(const CaseState& state, const atlas::Proposal& proposal, const Points& landmark,
                    const std::optional<Eigen::VectorXd>& known) {
  require_proposed(state, proposal.structure);
  auto transfer = std::make_shared<atlas::Transfer>(*state[part::proposals]);
  *std::ranges::find(transfer->proposals, proposal.structure, &atlas::Proposal::structure) = proposal;
  Applied applied{state};
  applied.state[part::proposals] = std::move(transfer);
  applied.state = with_landmark(applied.state, proposal.structure, landmark,
                                known ? *known : atlas::landmark_deviations(proposal, landmark));
  propose_others_again(applied.state);
  return applied;
}

atlas::Evidence with_own_ridge(const CaseState& state, atlas::Evidence evidence) {
  if (const Points margin = marks_by_hand(state, atlas::Structure::anterior_margin); margin.rows() > 0)
    evidence.ridge = margin;
  return evidence;
}

void propose_others_again(CaseState& state) {
  auto transfer = std::make_shared<atlas::Transfer>(*state[part::proposals]);
  const PatientModel& model = state[part::model]->model;
  atlas::propose_again(*transfer, fine_liver(model), with_own_ridge(state, atlas::courses_of(model)));
  state[part::proposals] = std::move(transfer);
}

std::vector<std::optional<atlas::Source>> proposed_sources(const CaseState& state,
                                                           atlas::Structure structure) {
  const Points points = placed_points(state, structure);
  const atlas::Proposal* proposal = proposal_of(state, structure);
  if (proposal != nullptr) return atlas::landmark_sources(*proposal, points);
  return std::vector<std::optional<atlas::Source>>(static_cast<std::size_t>(points.rows()));
}

bool rests_on_proposal(const CaseState& state, atlas::Structure structure) {
  const auto sources = proposed_sources(state, structure);
  return std::any_of(sources.begin(), sources.end(), [](const auto& source) { return source.has_value(); });
}

Points marks_by_hand(const CaseState& state, atlas::Structure structure) {
  const Points placed = placed_points(state, structure);
  const auto proposed = proposed_sources(state, structure);
  Landmarks of_model = state[part::model]->model.landmarks;
  const Points* models = points_of(of_model, structure);
  const Eigen::VectorXd deviations = placed_deviations(state, structure);
  if (deviations.size() > 0 && deviations.maxCoeff() > 0.0) return Points(0, 3);  // a guess of before
  Points marks(placed.rows(), 3);
  Eigen::Index count = 0;
  for (Eigen::Index i = 0; i < placed.rows(); ++i) {
    const Eigen::RowVector3d p = placed.row(i);
    const bool is_models = models->rows() > 0 && (models->rowwise() - p).rowwise().norm().minCoeff() < kSame;
    if (!is_models && !proposed[static_cast<std::size_t>(i)]) marks.row(count++) = p;
  }
  return marks.topRows(count);
}

CaseState with_marks_alone(const CaseState& state, atlas::Structure structure) {
  return with_landmark(state, structure, marks_by_hand(state, structure), {});
}

Applied with_decision(const CaseState& state, const atlas::Proposal& reviewed) {
  const atlas::Structure structure = reviewed.structure;
  const Points marks = marks_by_hand(state, structure);
  if (reviewed.decision == atlas::Decision::moved || marks.rows() == 0)
    return with_review(state, reviewed, atlas::landmark_left_by(reviewed));
  if (reviewed.decision != atlas::Decision::accepted) return with_review(state, reviewed, marks);
  Applied applied =
      with_review(state, reviewed, placed_points(state, structure), placed_deviations(state, structure));
  if (mark_stands(state, structure))
    applied.notes.push_back(std::string("landmarks.mark_stays ") + atlas::structure_code(structure));
  return applied;
}

bool landmark_is_as_reviewed(const CaseState& state, atlas::Structure structure) {
  const atlas::Proposal* proposal = proposal_of(state, structure);
  Landmarks of_model = state[part::model]->model.landmarks;
  const Points* models = points_of(of_model, structure);
  if (proposal == nullptr || models == nullptr) return true;
  const auto effective = [&](const Points& points) { return points.rows() > 0 ? points : *models; };
  const Points left = effective(atlas::landmark_left_by(*proposal)),
               now = effective(placed_points(state, structure));
  return left.rows() == now.rows() && (left.rows() == 0 || (left - now).cwiseAbs().maxCoeff() < kSame);
}

}  // namespace glisson::engine
