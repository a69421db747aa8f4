// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/experiments/aims.h"

namespace glisson::app {

/// What the program leaves with.
enum ExitCode : int {
  kDone = 0,
  kFailed = 1,      ///< an error; an aim that is not met
  kUsage = 2,       ///< the command line itself
  kIncomplete = 3,  ///< no aim is missed, but some could not be measured, or not on all: data are not there
  kRefused = 3,     ///< a result was reached, and evidence contradicts it: nothing was written
  kCancelled = 130
};

constexpr int exit_code(experiments::Verdict verdict) {
  return verdict == experiments::Verdict::met      ? kDone
         : verdict == experiments::Verdict::missed ? kFailed
                                                   : kIncomplete;
}

}  // namespace glisson::app
