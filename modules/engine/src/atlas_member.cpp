// SPDX-License-Identifier: GPL-3.0-or-later
#include "atlas_member.h"

#include <algorithm>

#include "glisson/engine/obstacle.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/proposals.h"
#include "review_step.h"

namespace glisson::engine {
namespace {
using atlas::Source;
using atlas::Structure;

/// Placed points without those that an atlas has put there.
Points without_proposed(const CaseState& state, Structure structure) {
  const Points placed = placed_points(state, structure);
  const auto proposed = proposed_sources(state, structure);
  Points own(placed.rows(), 3);
  Eigen::Index count = 0;
  for (Eigen::Index i = 0; i < placed.rows(); ++i)
    if (proposed[static_cast<std::size_t>(i)].value_or(Source::person) == Source::person)
      own.row(count++) = placed.row(i);
  return own.topRows(count);
}

/// The margin where a person's word is there for its whole course: all points of a proposal of which a person
/// has set both ends, and the image or the person the rest; or another line than the model's detected crest.
Points whole_margin(const CaseState& state) {
  const Points placed = placed_points(state, Structure::anterior_margin);
  const auto proposed = proposed_sources(state, Structure::anterior_margin);
  const auto is_proposed = [](const auto& source) { return source.has_value(); };
  if (std::none_of(proposed.begin(), proposed.end(), is_proposed))
    return marks_by_hand(state, Structure::anterior_margin).rows() == placed.rows() ? placed : Points(0, 3);
  const bool is_whole = placed.rows() == atlas::point_count(Structure::anterior_margin) &&
                        std::all_of(proposed.begin(), proposed.end(), is_proposed) &&
                        std::find(proposed.begin(), proposed.end(), Source::statistics) == proposed.end() &&
                        proposed.front() == Source::person && proposed.back() == Source::person;
  return is_whole ? placed : Points(0, 3);
}

}  // namespace

atlas::Member atlas_member(const std::string& name, const CaseState& state) {
  require_parts(state, {part::model});
  Landmarks placed;
  placed.umbilical_notch = without_proposed(state, Structure::umbilical_notch);
  placed.vena_cava = without_proposed(state, Structure::vena_cava);
  placed.anterior_margin = whole_margin(state);
  return atlas::member_of(name, state[part::model]->model, placed);
}

}  // namespace glisson::engine
