// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/atlas/transfer.h"

namespace glisson::engine {

/// What a review leaves as the landmark of a proposal's structure, by what was decided: points in the CT's
/// frame, metres; none where it is not accepted, or shows too little.
Points landmark_left_by(const atlas::Proposal& proposal);

}  // namespace glisson::engine
