// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/engine/case_state.h"
#include "glisson/fem/tissue.h"

namespace glisson::engine {

namespace part {
/// How stiff this patient's parenchyma and lesions are; absent: nobody has said.
extern const PartOf<fem::Tissue> tissue;
}  // namespace part

/// What is said of it, or nothing. @param with_parenchyma false: the lesions alone, where a command brings
/// materials of its own.
fem::Tissue tissue_of(const CaseState& state, bool with_parenchyma = true);

}  // namespace glisson::engine
