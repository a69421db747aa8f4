// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "glisson/stereo/source.h"
#include "streams.h"
#include "views.h"

namespace glisson::stereo {

/// Both views in each picture of a stream. @throws InputError there are no two halves; reading: the stream
/// breaks off, or a picture is of another size.
std::unique_ptr<Views> views_of(std::unique_ptr<PictureStream> whole, Layout layout);
/// A view each, matched by their times. @param largest_skew seconds; 0: half a frame.
/// @throws InputError sizes or rates differ; reading: as above, or nothing is of one moment.
std::unique_ptr<Views> views_of(std::unique_ptr<PictureStream> left, std::unique_ptr<PictureStream> right,
                                double largest_skew);

}  // namespace glisson::stereo
