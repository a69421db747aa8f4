// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "glisson/engine/command.h"

namespace glisson::engine {

/// While the organ is followed: from now on this network says what is not liver, or none does.
struct SetMaskNetwork {
  std::filesystem::path network;  ///< ONNX, its sheet beside it; empty: none

  CommandTraits traits() const;
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context,
                             const Services& services) const;
};

}  // namespace glisson::engine
