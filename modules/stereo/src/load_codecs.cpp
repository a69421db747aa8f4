// SPDX-License-Identifier: GPL-3.0-or-later
#include "../codecs/opencv_codecs.h"
#include "glisson/core/late_library.h"

namespace glisson::stereo {

const Codecs& codecs() {
  static const Codecs& kLoaded =
      **static_cast<const Codecs* const*>(late_symbol("glisson-codecs.so", kCodecsSymbol));
  return kLoaded;
}

}  // namespace glisson::stereo
