// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glisson/core/confinement.h"

namespace glisson::test {

inline bool can_confine() {
  const Confinement can = possible_confinement();
  return can.files || can.calls;
}

/// Of what a confined program could do, that which this kernel can hold: it says so itself.
inline std::vector<std::string> broken_out(std::vector<std::string> escapes) {
  const Confinement can = possible_confinement();
  std::erase_if(escapes, [&can](const std::string& one) {
    return one == "read" || one == "write" ? !can.files : !can.calls;
  });
  return escapes;
}

}  // namespace glisson::test
