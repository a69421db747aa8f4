// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/placed_correction.h"

#include "glisson/core/error.h"
#include "glisson/engine/parts/landmarks.h"
#include "glisson/engine/parts/live.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/rig.h"
#include "glisson/guidance/place_picker.h"

namespace glisson::engine {

Correction placed_correction(const CaseState& state, const CorrectionLine& line,
                             const std::filesystem::path& file) {
  Correction correction = *line.correction;
  const Points& nodes = state[part::live]->overlay.nodes_in_camera;
  if (line.has_place) {  // where it is seen counts; where it is drawn the frame says
    const auto drawn = guidance::pixel_of(state[part::model]->model, nodes, *state[part::rig],
                                          correction.view, correction.place_in_ct);
    correction.from = drawn.value_or(correction.from);
    return correction;
  }
  const auto picked = guidance::pick_place(effective_model(state), nodes, *state[part::rig], correction.view,
                                           correction.from);
  if (!picked)
    throw InputError(file.string(), "from of frame " + std::to_string(line.frame), "is beside the organ",
                     "Give a pixel of the drawn organ");
  correction.feature = picked->feature;
  correction.place_in_ct = picked->place_in_ct;
  correction.from = picked->pixel;
  return correction;
}

}  // namespace glisson::engine
