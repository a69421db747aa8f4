// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "glisson/engine/command.h"

namespace glisson::engine {

/// The frame `index` of the case's video, to be labelled and registered.
struct LoadVideoFrame {
  int index = 0;
  std::filesystem::path mask = {};  ///< may be empty

  CommandTraits traits() const;
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
