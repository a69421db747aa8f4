// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>

#include "glisson/engine/command.h"
#include "glisson/engine/saved_image.h"

namespace glisson::engine {

/// Saves the case as it is to a recovery folder, and leaves the case and its own place alone.
struct KeepCopy {
  std::filesystem::path folder;  ///< RecoveryFolder::path()
  /// Which file holds the image, for all copies of one folder; null: each looks at the case's alone.
  std::shared_ptr<SavedImage> saved = nullptr;

  CommandTraits traits() const;
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
