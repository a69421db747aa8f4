// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/import_registration.h"

#include "glisson/engine/case_io.h"
#include "glisson/engine/parts/former_registration.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/engine/parts/tissue.h"
#include "registration_figures.h"

namespace glisson::engine {

CommandTraits ImportRegistration::traits() const {
  return {.code = "import_registration",
          .reads = {part::model, part::tissue},
          .writes = {part::registration, part::former_registration},
          .needs = {part::model},
          .notice = Notice::files};
}

Cancellable<Applied> ImportRegistration::apply(const CaseState& state, const RunContext&) const {
  Applied applied{state};
  applied.state[part::former_registration] = nullptr;  // that came from elsewhere, too
  applied.state[part::registration] =
      std::make_shared<const Registration>(read_registration(path, state[part::model]->model, unit));
  applied.notes = told_of(*applied.state[part::registration]);
  return applied;
}

}  // namespace glisson::engine
