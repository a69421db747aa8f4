// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/engine/command.h"
#include "glisson/fem/tissue.h"

namespace glisson::engine {

/// Somebody says how stiff this patient's parenchyma and lesions are. A registration made before is out of
/// date then.
struct SetTissue {
  fem::Tissue tissue;

  CommandTraits traits() const;
  /// @throws InputError a lesion that the model does not have, a modulus out of range.
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
