// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/patient/picture.h"

namespace glisson::guidance {

/// How much a picture shows, whatever it shows.
struct PictureMeasures {
  double brightness = 0.0;  ///< median grey level
  double detail = 0.0;      ///< rms difference of the means of neighbouring blocks, grey levels
  double noise = 0.0;       ///< standard deviation within blocks that no structure explains, grey levels
  double signal() const;    ///< detail over noise
};

/// Measured on blocks of 4 x 4 pixels of the green channel (or of a grey picture), highlights left out. In
/// pictures wider than 960 the pixels of a block lie apart (pixel_scale()), so that it covers as much of the
/// tissue. About a millisecond. @pre not empty.
PictureMeasures measure(const Picture& picture);
/// What later pictures are compared with: a picture that begins in smoke or the dark is no norm.
double signal_at_start(const Picture& first, double least);

}  // namespace glisson::guidance
