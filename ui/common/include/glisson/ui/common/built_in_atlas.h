// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "glisson/atlas/atlas.h"

namespace glisson::ui {

/// The atlas that comes with the program (resources/atlas). Read once; safe from any thread.
/// @throws Error it cannot be unpacked.
std::shared_ptr<const atlas::Atlas> built_in_atlas();

}  // namespace glisson::ui
