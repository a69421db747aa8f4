// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "glisson/core/units.h"
#include "glisson/geometry/mesh.h"

namespace glisson {

/// As the one of mesh_io.h, with what tells units apart that the diagonal does not: read as centimetres a
/// liver in inches still has the diagonal of a small one, but a sixteenth of its volume.
/// @param unit in which `name` was read. @param volume of the closed surface or mesh, m3; empty: not known.
/// @throws InputError when it cannot be a liver; the remedy names the unit that would fit, if one does.
void check_liver_size(const Points& points, LengthUnit unit, const std::string& name,
                      std::optional<double> volume);

}  // namespace glisson
