// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glisson/registration/findings.h"

namespace glisson::registration {

/// What the findings amount to.
struct Verdict {
  std::vector<std::string> doubts;  ///< a code, what was found, the limit
  bool refused = false;
};

Verdict judge(const Findings& findings);

}  // namespace glisson::registration
