// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/set_tissue.h"

#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/tissue.h"
#include "glisson/patient/label_map.h"

namespace glisson::engine {
namespace {

std::vector<std::string> notes_of(const fem::Tissue& tissue, const PatientModel& model) {
  std::vector<std::string> notes;
  for (const Label lesion : fem::lesions_without_elements(tissue, model))
    notes.push_back("tissue.no_elements " + structure_name(lesion));
  return notes;
}

}  // namespace

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
  Applied applied{state, {}, notes_of(tissue, model)};
  const fem::Tissue said = fem::rounded(tissue);  // as a case on disk keeps it
  if (said == tissue_of(state)) return applied;   // nothing becomes out of date
  applied.state[part::tissue] = said.empty() ? nullptr : std::make_shared<const fem::Tissue>(said);
  return applied;
}

}  // namespace glisson::engine
