// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "glisson/atlas/transfer.h"
#include "glisson/engine/command.h"
#include "glisson/patient/patient_model.h"

namespace glisson::engine {

/// Takes steps of the review back: proposals and landmarks as they were before.
struct RestoreReview {
  std::shared_ptr<const atlas::Transfer> proposals;
  std::shared_ptr<const Landmarks> landmarks;  ///< null: nobody had placed any

  CommandTraits traits() const;
  /// @pre proposals. @throws InputError they were made for another model.
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
