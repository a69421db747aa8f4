// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

namespace glisson::scene {

/// Draws an empty scene into memory, as OffscreenRenderer does.
/// @return what the driver says of itself while its context is current: "vendor", "renderer" and "version",
/// as far as it says them.
/// @throws Error nothing was drawn, or this machine offers no EGL.
std::map<std::string, std::string> try_drawing();

}  // namespace glisson::scene
