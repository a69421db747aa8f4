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

/// Limits: EVIDENCE.md.
Verdict judge(const Findings& findings);

/// What a twentieth of operations like those of the prior exceed: 95 % of chi-square over its degrees of
/// freedom (Wilson and Hilferty 1931). @param modes that the cloud decides, as a number: 1 at least.
double strangest(double modes);

}  // namespace glisson::registration
