// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>

#include "glisson/core/units.h"
#include "glisson/engine/command.h"
#include "glisson/patient/labelled_cloud.h"

namespace glisson::engine {

/// More would take longer to join than to look once more at what matters.
inline constexpr std::size_t kMostLooks = 8;

/// Keeps a cloud as an earlier look at the organ, which is joined to the case's cloud when the model is
/// registered: the case's cloud as it is now, the one that a person looks at, or one of a file.
/// @throws InputError it is kept already, or kMostLooks are; as ImportCloud for a file.
struct KeepLook {
  std::optional<std::filesystem::path> path;  ///< PLY; empty: the case's cloud
  LengthUnit unit = LengthUnit::millimetre;   ///< of the file
  /// Without a file: the one that the person looks at, whatever the case holds by then, so that another one
  /// that is just being made does not take its place. Null: the case's cloud.
  std::shared_ptr<const LabelledCloud> seen = {};

  CommandTraits traits() const;
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
