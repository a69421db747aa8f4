// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "glisson/editing/edit.h"
#include "glisson/engine/command.h"

namespace glisson::engine {

/// What an edit would do, as the part `preview`; empty: it goes.
struct PreviewEdit {
  std::optional<editing::Edit> edit;

  CommandTraits traits() const;
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
