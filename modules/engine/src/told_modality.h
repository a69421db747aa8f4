// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "glisson/core/error.h"
#include "glisson/volume/image.h"

namespace glisson::engine {

/// @param is_dicom whether the image is from DICOM files, which have told its modality.
/// @throws InputError naming `file` where they have told another one than a person chose.
inline void require_modality_untold(const Image& image, bool is_dicom, Modality chosen,
                                    const std::string& file) {
  if (chosen != image.modality && is_dicom)
    throw InputError(file, "modality", "is told by its DICOM files, and is another one",
                     "Leave the choice out");
}

}  // namespace glisson::engine
