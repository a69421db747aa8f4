// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/engine/case_state.h"
#include "glisson/patient/picture.h"

namespace glisson::engine {

/// A stereo pair as it was taken, with what may be used of it.
struct StereoInput {
  StereoFrame frame;
  Picture mask;  ///< one byte a pixel of the left image, non-zero is tissue; empty: everything
};

namespace part {
/// The pair that is labelled and registered.
extern const PartOf<StereoInput> frame;
}  // namespace part

}  // namespace glisson::engine
