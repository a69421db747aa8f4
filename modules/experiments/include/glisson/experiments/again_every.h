// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "glisson/core/run_context.h"
#include "glisson/engine/command.h"
#include "glisson/engine/commands/register_again.h"
#include "glisson/patient/overlay_record.h"

namespace glisson::experiments {

/// Registers again every so many seconds of a film that is followed, without a person, and goes over to what
/// is better by its evidence.
class AgainEvery {
 public:
  /// Does a command. @throws Error when it fails or is cancelled.
  using Post = std::function<void(engine::Command)>;
  using State = std::function<const engine::CaseState&()>;

  /// @param seconds zero: never. @param command as it was registered first.
  AgainEvery(double seconds, engine::RegisterAgain command, Post post, State state);

  struct Tried {
    AgainLine line;
    std::string problem;  ///< why it could not be registered; empty: it was
  };
  /// After each frame. While the organ is not followed, or too little of it has been seen, it is put off from
  /// frame to frame; a registration that fails leaves the former one.
  /// @return empty: not yet due. @throws Error cancelled.
  std::optional<Tried> after(int frame, double seconds, const RunContext& context);

 private:
  double every_, last_ = 0.0;
  engine::RegisterAgain command_;
  Post post_;
  State state_;
};

}  // namespace glisson::experiments
