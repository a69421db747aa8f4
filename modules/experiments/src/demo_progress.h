// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "glisson/core/run_context.h"
#include "glisson/experiments/demo.h"

namespace glisson::experiments {

/// One fraction for the whole demo, that never goes back: each stage fills the share of the time that it
/// typically takes.
class DemoProgress {
 public:
  DemoProgress(const DemoOptions& options, const RunContext& context);

  /// A stage begins. What is reported to the context that is returned fills that stage's share; a stage that
  /// is not planned takes no time to speak of.
  RunContext begin(const std::string& stage);

 private:
  RunContext context_;
  std::vector<std::pair<std::string, double>> plan_;  ///< stages in their order, seconds
  std::size_t next_ = 0;
  double done_ = 0.0, total_ = 0.0;  ///< seconds
};

}  // namespace glisson::experiments
