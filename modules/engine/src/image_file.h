// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace glisson::engine {

/// The image in a case's folder.
inline constexpr const char* kImageFile = "image.nrrd";

}  // namespace glisson::engine
