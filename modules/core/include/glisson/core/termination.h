// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace glisson {

/// How an iteration ended, the same words for every solver that reports it. Cancel is none of them: it leaves
/// a Cancellable empty.
enum class Termination {
  converged,   ///< the tolerance was reached
  step_limit,  ///< all allowed steps were done, none of them bad: the result may be used with that doubt
  diverged     ///< no longer finite, or no step leads on: not to be trusted
};

}  // namespace glisson
