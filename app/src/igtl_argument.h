// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "cli.h"
#include "glisson/model/build.h"
#include "glisson/openigtlink/sender.h"

namespace glisson::app {

/// --igtl-send: tells other programs of each frame while a command follows a video or clouds. Without the
/// option nothing is opened and nothing told.
class FrameTeller {
 public:
  static void declare(Arguments& arguments);

  /// Listens, where it is asked for, and says where. @throws InputError, UsageError.
  explicit FrameTeller(const Arguments& arguments);
  /// What is followed; waits for a peer, where that is asked for. @throws Interrupted.
  void begin(const std::shared_ptr<const model::BuiltModel>& tracked, const RunContext& context);
  /// @pre begin() was called.
  void tell(const OverlayFrame& overlay);

 private:
  bool waits_ = false;
  std::unique_ptr<openigtlink::Sender> sender_;
  std::shared_ptr<const openigtlink::SentModel> model_;
};

}  // namespace glisson::app
