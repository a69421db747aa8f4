// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>

#include "glisson/patient/label_map.h"
#include "glisson/patient/labelled_cloud.h"

namespace glisson::scene {

/// structure_colour() for Qt: one structure has one colour in slices, 3D view, overlay and lists.
QColor colour_of(Label structure);
/// One feature has one colour as a region, as points and as a landmark.
QColor colour_of(Feature feature);

}  // namespace glisson::scene
