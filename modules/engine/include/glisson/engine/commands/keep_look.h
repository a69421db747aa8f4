// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>

#include "glisson/core/units.h"
#include "glisson/engine/command.h"

namespace glisson::engine {

/// More would take longer to join than to look once more at what matters.
inline constexpr std::size_t kMostLooks = 8;

/// Keeps a cloud as an earlier look at the organ, which is joined to the case's cloud when the model is
/// registered: the case's cloud as it is now, or one of a file.
/// @throws InputError it is kept already, or kMostLooks are; as ImportCloud for a file.
struct KeepLook {
  std::optional<std::filesystem::path> path;  ///< PLY; empty: the case's cloud
  LengthUnit unit = LengthUnit::millimetre;   ///< of the file

  CommandTraits traits() const;
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
