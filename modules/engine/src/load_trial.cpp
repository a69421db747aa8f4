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

}  // namespace

Cancellable<std::unique_ptr<LoadTrial>> make_load_trial(const CaseState& state, const TrialOptions& options,
                                                        const RunContext& context) {
  require(state.has(part::model), "a load is tried on a model");
  options.validate();
  const PatientModel model = effective_model(state);
  if (model.mesh.tetrahedron_count() == 0)
    throw InputError("model", "mesh", "has no tetrahedra", "Build the model again");
  const guidance::BoundarySprings springs(model, model.mesh.vertices, options.boundary_young_modulus,
                                          options.boundary_length, kFixedEnds);
  if (springs.count() == 0)
    throw InputError("model", "vena cava", "is not known, nor where a vessel enters: nothing holds the organ",
                     "Place the vena cava among the landmarks");
  if (!fem::is_held(model))
    throw InputError(
        "model", "vena cava",
        "and the places where vessels enter lie on one line, about which the organ would turn freely",
        "Place three points or more of the vena cava among the landmarks, where it touches the liver");
  context.progress(0.1, "trial.model");
  auto composite = std::make_shared<const fem::CompositeModel>(
      model.mesh, model.vessels, fem::with_tissue(options.materials, tissue_of(state), model.mesh));
  if (context.cancelled()) return {};
  context.progress(0.5, "trial.solver");
  auto trial = fem::make_load_trial(
      composite,
      [springs](const Points& nodes, std::vector<fem::AttachedLoad>& loads) { springs.add(nodes, loads); },
      options);
  if (context.cancelled()) return {};
  return trial;
}

}  // namespace glisson::engine
