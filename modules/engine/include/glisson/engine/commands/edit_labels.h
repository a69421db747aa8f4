// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "glisson/editing/edit.h"
#include "glisson/engine/command.h"

namespace glisson::engine {

/// One edit of the labels. Done at once where its tool is local (see editing::is_local); with the result
/// of the preview where that is of the same edit.
struct EditLabels {
  editing::Edit edit;
  /// Edits of one gesture (not 0), as the pieces of a stroke, are one step of the history.
  std::uint64_t gesture = 0;

  CommandTraits traits() const;
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
