// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glisson/volume/image.h"
#include "painting.h"
#include "tissue.h"

namespace glisson::segmentation {

/// Notes about lesions that are brighter than the liver, as veins are: "lesion_6.perhaps_vein 47" where a
/// vein of the two trees goes on behind so many per cent of its surface, else "lesion_6.bright".
/// @param image on the scale of a CT, of the painting's grid. @param lesions how many were looked for.
std::vector<std::string> bright_lesion_notes(const Image& image, const Painting& painting,
                                             std::size_t lesions, const Tissue& parenchyma);

}  // namespace glisson::segmentation
