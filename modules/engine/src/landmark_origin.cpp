// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/landmark_origin.h"

#include "glisson/core/error.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/proposals.h"

namespace glisson::engine {
namespace {
using atlas::Structure;

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
    const bool is_placed = placed_points(state, structure).rows() > 0;
    if (proposed != nullptr) {
      one.source = proposed->source();
      one.deviation = proposed->deviation();
      one.decision = proposed->decision;
    }
    // Points that a person has set without a proposal, or against it, and what the model shows by itself.
    const bool is_proposal = proposed != nullptr && (proposed->decision == atlas::Decision::accepted ||
                                                     proposed->decision == atlas::Decision::moved);
    if (one.is_used && !is_proposal) {
      one.source = is_placed ? atlas::Source::person : atlas::Source::image;
      one.deviation.reset();
    }
    all.push_back(one);
  }
  return all;
}

}  // namespace glisson::engine
