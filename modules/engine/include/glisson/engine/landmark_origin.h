// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "glisson/atlas/transfer.h"
#include "glisson/engine/case_state.h"

namespace glisson::engine {

/// Where what the case knows of a structure comes from, and what a person made of it.
struct LandmarkOrigin {
  atlas::Structure structure = atlas::Structure::umbilical_notch;
  std::optional<atlas::Source> source;      ///< empty: nothing is known of it
  std::optional<double> deviation;          ///< metres, as the atlas tells it; empty: nothing was proposed
  std::optional<atlas::Decision> decision;  ///< empty: nothing was proposed
  bool is_used = false;                     ///< the registration has it as a landmark
};

/// One for each structure that an atlas may know, in their order: the table of decisions of a case.
/// @pre the case has a model
std::vector<LandmarkOrigin> landmark_origins(const CaseState& state);

/// Whether marks that a person has placed by hand are used in the place of what is proposed for a structure.
/// Not where the proposal was made of them.
bool mark_stands(const CaseState& state, atlas::Structure structure);

}  // namespace glisson::engine
