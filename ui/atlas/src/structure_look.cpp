// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/atlas/structure_look.h"

#include "glisson/ui/scene/colours.h"

namespace glisson::ui {
using atlas::Structure;

QColor colour_of(Structure structure) {
  switch (structure) {
    case Structure::umbilical_notch:
      return scene::colour_of(Feature::umbilical_notch);
    case Structure::anterior_margin:
      return scene::colour_of(Feature::anterior_margin);
    case Structure::falciform_line:
      return {255, 214, 90};
    case Structure::vena_cava:
      return scene::colour_of(structure::kVenaCava);
    case Structure::portal_entrance:
      return scene::colour_of(structure::kPortalVein);
    case Structure::gallbladder_bed:
      return scene::colour_of(structure::kGallbladder);
  }
  return {};
}

Label neighbour_of(Structure structure) {
  if (structure == Structure::vena_cava) return structure::kVenaCava;
  return structure == Structure::gallbladder_bed ? structure::kGallbladder : structure::kBackground;
}

bool is_line(Structure structure) {
  return structure == Structure::falciform_line || structure == Structure::anterior_margin;
}

}  // namespace glisson::ui
