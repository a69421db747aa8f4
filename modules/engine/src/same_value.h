// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/engine/case_state.h"

namespace glisson::engine {

/// PartSpec::same of a part whose values can be compared.
template <class T>
auto same_value(const PartOf<T>& part) {
  return [&part](const CaseState& written, const CaseState& read) { return *written[part] == *read[part]; };
}

}  // namespace glisson::engine
