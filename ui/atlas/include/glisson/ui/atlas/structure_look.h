// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>

#include "glisson/atlas/structure.h"
#include "glisson/patient/label_map.h"

namespace glisson::ui {

/// The colour that a structure has everywhere.
QColor colour_of(atlas::Structure structure);
/// What touches the liver there, and hides it from the eye; background: nothing.
Label neighbour_of(atlas::Structure structure);
/// Whether its points are a course.
bool is_line(atlas::Structure structure);

}  // namespace glisson::ui
