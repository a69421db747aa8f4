// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/scene/colours.h"

namespace glisson::scene {

QColor colour_of(Label structure) {
  const auto rgb = structure_colour(structure);
  return QColor::fromRgbF(static_cast<float>(rgb[0]), static_cast<float>(rgb[1]), static_cast<float>(rgb[2]));
}

QColor colour_of(Feature feature) {
  switch (feature) {
    case Feature::surface:
      return {86, 180, 233};
    case Feature::anterior_margin:
      return {245, 245, 245};
    case Feature::umbilical_notch:
      return {255, 64, 208};  // no structure is near it: lesions may be orange
  }
  return {};
}

}  // namespace glisson::scene
