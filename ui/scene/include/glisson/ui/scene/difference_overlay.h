// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>

#include "glisson/patient/label_map.h"
#include "glisson/ui/scene/slice_picture.h"

/// @file
/// What would become of labels, in three colours that a person who does not tell red from green does (Okabe
/// and Ito 2008), each with a hatching of its own.

namespace glisson::scene {

enum class Change {
  none,
  added,    ///< nothing was there: sky blue, hatched upwards
  removed,  ///< nothing will be there: orange, hatched downwards
  renamed   ///< another structure: yellow, crossed
};
Change change_of(Label was, Label will);

/// To be laid over a slice's picture: each change hatched, with an outline; white and filled more densely
/// where a hand has corrected (`hand` is not 0). Null when nothing changes there. @pre one grid.
QImage difference_overlay(const LabelVolume& before, const LabelVolume& after, const LabelVolume& hand,
                          const SliceGeometry& geometry);

/// The same for a legend. @pre not `none`; width and height above 2.
QImage difference_swatch(Change change, bool by_hand, int width, int height);

}  // namespace glisson::scene
