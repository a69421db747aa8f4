// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/engine/command.h"
#include "glisson/volume/image.h"

namespace glisson::engine {

/// What the case's image is, where its file did not say.
struct SetModality {
  Modality modality = Modality::ct;

  CommandTraits traits() const;
  /// @throws InputError its DICOM files say another one.
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
