// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/patient_held.h"

#include "glisson/core/error.h"
#include "glisson/engine/parts/cloud.h"
#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/model.h"

namespace glisson::engine {

bool holds_patient(const CaseState& state) {
  return state[part::image] || state[part::labels] || state[part::model] || state[part::cloud];
}

void require_no_patient(const CaseState& state, const std::filesystem::path& folder) {
  if (holds_patient(state))
    throw InputError(folder.string(), "", "is a case already",
                     "Choose another one for another patient; for another image of the same patient give "
                     "--replace: all else stays, marked out of date");
}

}  // namespace glisson::engine
