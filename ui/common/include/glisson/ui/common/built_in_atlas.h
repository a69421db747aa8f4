// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "glisson/atlas/atlas.h"

namespace glisson::ui {

/// The atlas that comes with the program (resources/atlas). Read once; safe from any thread.
/// @throws Error it cannot be unpacked.
std::shared_ptr<const atlas::Atlas> built_in_atlas();
/// The same for checks that can be left out: null where it cannot be unpacked, as on a full disk.
std::shared_ptr<const atlas::Atlas> built_in_atlas_if_any();

}  // namespace glisson::ui
