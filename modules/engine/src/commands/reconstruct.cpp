// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/reconstruct.h"

#include "glisson/engine/parts/cloud.h"
#include "glisson/engine/parts/frame.h"
#include "glisson/engine/parts/regions.h"
#include "glisson/engine/parts/rig.h"
#include "glisson/stereo/reconstruct_pair.h"

namespace glisson::engine {
namespace {

/// Points that an earlier command has made of the same pair.
stereo::KnownPoints known_points(const CaseState& state) {
  const auto& known = state[part::points];
  if (!known || known->frame != state[part::frame] || known->rig != state[part::rig]) return {};
  return {known->options, known->whole};
}

stereo::PairInput input_of(const CaseState& state) {
  const auto& frame = state[part::frame];
  const auto& regions = state[part::regions];
  return {frame->frame, *state[part::rig], frame->mask, regions ? *regions : stereo::Regions{}};
}

std::vector<std::string> notes_of(const stereo::PairCloud& made) {
  std::vector<std::string> notes;
  if (!made.check) return notes;
  for (const stereo::Fault fault : made.check->faults) notes.push_back(stereo::fault_note(fault));
  return notes;
}

Figures figures_of(const stereo::PairCloud& made) {
  Figures figures;
  if (made.check) {
    figures["pair_matches"] = made.check->matches;
    figures["pair_rows_px"] = made.check->rows_px;
  }
  const stereo::ReconstructReport& report = made.whole->report;
  figures["cloud_features_left"] = report.features_left;
  figures["cloud_features_right"] = report.features_right;
  figures["cloud_matches"] = report.matches;
  figures["cloud_points"] = made.part.cloud.size();
  figures["cloud_area_cm2"] = made.part.area_cm2;
  figures["cloud_density_per_cm2"] = made.part.density_per_cm2;
  figures["cloud_covered_share"] = made.density.covered;
  figures["cloud_row_offset_px"] = report.row_offset_px;
  figures["cloud_epipolar_rms_px"] = report.epipolar_rms_px;
  figures["cloud_sigma_median_mm"] = 1e3 * report.sigma_median;
  figures["cloud_dense"] = report.method == stereo::Method::dense ? 1.0 : 0.0;
  return figures;
}

/// The cloud, and the points that it was made of.
void put(CaseState& state, const stereo::ReconstructOptions& options, stereo::PairCloud made) {
  state[part::points] = std::make_shared<const PairPoints>(
      PairPoints{state[part::frame], state[part::rig], options, std::move(made.whole), made.part.area_cm2,
                 made.part.density_per_cm2, std::move(made.density), std::move(made.frame_identity)});
  state[part::cloud] = std::make_shared<const LabelledCloud>(std::move(made.part.cloud));
}

}  // namespace

CommandTraits Reconstruct::traits() const {
  return {.code = "reconstruct",
          .reads = {part::rig, part::frame, part::regions},
          .writes = {part::cloud},
          .needs = {part::rig, part::frame}};
}

Cancellable<Applied> Reconstruct::apply(const CaseState& state, const RunContext& context) const {
  auto made = stereo::reconstruct_pair(input_of(state), options, context, known_points(state));
  if (!made) return {};
  Applied applied{state, figures_of(*made), notes_of(*made)};
  put(applied.state, options, std::move(*made));
  return applied;
}

}  // namespace glisson::engine
