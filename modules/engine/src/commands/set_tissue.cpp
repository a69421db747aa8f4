// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/set_tissue.h"

#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/tissue.h"
#include "glisson/patient/label_map.h"

namespace glisson::engine {

CommandTraits SetTissue::traits() const {
  return {.code = "set_tissue",
          .reads = {part::model},
          .writes = {part::tissue},
          .needs = {part::model},
          .lane = Lane::edits,
          .notice = Notice::quiet};
}

Cancellable<Applied> SetTissue::apply(const CaseState& state, const RunContext&) const {
  const PatientModel& model = state[part::model]->model;
  tissue.validate();
  fem::require_lesions_of(tissue, model);
  Applied applied{state};
  for (const Label lesion : fem::lesions_without_elements(tissue, model))
    applied.notes.push_back("tissue.no_elements " + structure_name(lesion));
  // The same once more makes nothing out of date.
  const fem::Tissue said = fem::rounded(tissue);  // as a case on disk keeps it
  if (said == tissue_of(state)) return applied;
  applied.state[part::tissue] = said.empty() ? nullptr : std::make_shared<const fem::Tissue>(said);
  return applied;
}

}  // namespace glisson::engine
