// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/landmark_origin.h"

#include "glisson/core/error.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/proposals.h"
#include "review_step.h"

namespace glisson::engine {
namespace {
using atlas::Structure;

constexpr double kElsewhere = 0.005;  // metres, from a person's mark to what is proposed by it

/// None: registration does not know the structure, or nothing is there.
Points points_of(const Landmarks& landmarks, Structure structure) {
  switch (structure) {
    case Structure::umbilical_notch:
      return landmarks.umbilical_notch;
    case Structure::anterior_margin:
      return landmarks.anterior_margin;
    case Structure::vena_cava:
      return landmarks.vena_cava;
    case Structure::falciform_line:
    case Structure::portal_entrance:
    case Structure::gallbladder_bed:
      break;
  }
  return Points(0, 3);
}

}  // namespace

std::vector<LandmarkOrigin> landmark_origins(const CaseState& state) {
  require(state[part::model] != nullptr, "landmarks belong to a model");
  std::vector<LandmarkOrigin> all;
  const Landmarks used = effective_landmarks(state);
  for (const Structure structure : atlas::kStructures) {
    LandmarkOrigin one{structure, {}, {}, {}, points_of(used, structure).rows() > 0};
    const atlas::Proposal* proposed = proposal_of(state, structure);
    if (proposed != nullptr) {
      one.source = proposed->source();
      one.deviation = proposed->deviation();
      one.decision = proposed->decision;
    }
    // Points that a person has set without a proposal, or against it, and what the model shows by itself.
    if (one.is_used && !rests_on_proposal(state, structure)) {
      const Eigen::VectorXd known = placed_deviations(state, structure);
      const bool is_guess = known.size() > 0 && known.maxCoeff() > 0.0;  // of a proposal that is gone
      const bool is_mark = marks_by_hand(state, structure).rows() > 0;
      one.source = is_guess  ? atlas::Source::statistics
                   : is_mark ? atlas::Source::person
                             : atlas::Source::image;
      one.deviation.reset();
    }
    all.push_back(one);
  }
  return all;
}

bool mark_stands(const CaseState& state, Structure structure) {
  const atlas::Proposal* proposed = proposal_of(state, structure);
  if (state[part::model] == nullptr || proposed == nullptr) return false;
  const Points marks = marks_by_hand(state, structure);
  if (marks.rows() == 0 || proposed->source() != atlas::Source::person) return marks.rows() > 0;
  const Points& known = proposed->area.rows() > 0 ? proposed->area : proposed->points;
  for (const auto mark : marks.rowwise())
    if ((known.rowwise() - mark).rowwise().norm().minCoeff() > kElsewhere) return true;
  return false;
}

}  // namespace glisson::engine
