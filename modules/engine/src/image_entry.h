// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "glisson/volume/image.h"

namespace glisson::engine {

inline constexpr const char* kImageFile = "image.nrrd";

/// What case.json says of the image beside its file.
nlohmann::json image_entry(const Image& image);

}  // namespace glisson::engine
