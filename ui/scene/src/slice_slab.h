// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "glisson/ui/scene/slice_picture.h"

namespace glisson::scene {

/// The brightest value of a slab about the slice, style.slab thick: of the slice itself and of the layers of
/// voxels within half the thickness on either side. Where the slice lies along the volume's axes the
/// layers' maximum is taken first and interpolated then: a vessel never becomes darker than in a layer.
/// @param bytes of the whole slice, as draw_grey(). @pre style.slab > 0.
void draw_slab(const Image& image, const SliceGeometry& slice, const SliceStyle& style,
               std::vector<std::uint8_t>& bytes);

}  // namespace glisson::scene
