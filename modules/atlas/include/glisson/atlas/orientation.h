// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "glisson/atlas/atlas.h"
#include "glisson/core/run_context.h"

/// @file
/// Whether a liver lies as livers lie in a CT, by its shape alone: a header that exchanges left and right, or
/// slices in the wrong order, show in no voxel and in no other organ where only the liver is known.

namespace glisson::atlas {

/// How badly the atlas' mean liver, held as livers lie in a CT, fits a liver and its images (without unit:
/// distance, normals and bends). The index says which axes are turned round in the image: x (left, right) 1,
/// y (front, back) 2, z (head, feet) 4; index 0 is the liver as it lies.
using ImageMisfits = std::array<double, 8>;

/// @param liver a closed surface, outward normals, metres. @pre it has a surface. Empty: cancelled.
Cancellable<ImageMisfits> image_misfits(const Atlas& atlas, const TriangleMesh& liver,
                                        const RunContext& context);

/// What speaks against the way a liver lies: "liver.axes_exchanged AXES", where an image of it fits the atlas
/// clearly better; AXES is "left_right", "front_back", "head_feet", or several of them joined by '+'. None:
/// it fits best as it lies, or nothing can be said (an open surface, or of no liver's size). It is a doubt
/// and no finding: a liver that disease or a surgeon has changed may look so, too. Empty: cancelled.
Cancellable<std::vector<std::string>> orientation_doubts(const Atlas& atlas, const TriangleMesh& liver,
                                                         const RunContext& context);

}  // namespace glisson::atlas
