// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/load_trial.h"

#include <vector>

#include "glisson/core/error.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/tissue.h"
#include "glisson/guidance/boundary_springs.h"

namespace glisson::engine {
namespace {

constexpr double kFixedEnds = 1e9;  ///< N/m of what the vessels hang on: none of it gives way

/// The springs of the tracking, from fixed ends. @throws InputError there is none.
fem::Holding holding_of(const PatientModel& model, const TrialOptions& options) {
  const guidance::BoundarySprings springs(model, model.mesh.vertices, options.boundary_young_modulus,
                                          options.boundary_length, kFixedEnds);
  if (springs.count() == 0)
    throw InputError("model", "vena cava", "is not known, nor where a vessel enters: nothing holds the organ",
                     "Place the vena cava among the landmarks");
  return [springs](const Points& nodes, std::vector<fem::AttachedLoad>& loads) { springs.add(nodes, loads); };
}

}  // namespace

Cancellable<std::unique_ptr<LoadTrial>> make_load_trial(const CaseState& state, const TrialOptions& options,
                                                        const RunContext& context) {
  require(state.has(part::model), "a load is tried on a model");
  const PatientModel model = effective_model(state);
  return fem::make_load_trial(
      model, tissue_of(state), [&] { return holding_of(model, options); }, options, context);
}

}  // namespace glisson::engine
