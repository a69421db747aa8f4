// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/atlas/structure.h"

namespace glisson::atlas {

int point_count(Structure structure) {
  switch (structure) {
    case Structure::umbilical_notch:
    case Structure::portal_entrance:
      return 1;
    case Structure::falciform_line:
      return 9;
    case Structure::anterior_margin:
      return 41;
    case Structure::vena_cava:
    case Structure::gallbladder_bed:
      return 5;
  }
  return 0;
}

const char* structure_code(Structure structure) {
  switch (structure) {
    case Structure::umbilical_notch:
      return "umbilical_notch";
    case Structure::falciform_line:
      return "falciform_line";
    case Structure::anterior_margin:
      return "anterior_margin";
    case Structure::vena_cava:
      return "vena_cava";
    case Structure::portal_entrance:
      return "portal_entrance";
    case Structure::gallbladder_bed:
      return "gallbladder_bed";
  }
  return "";
}

std::optional<Structure> structure_of(const std::string& name) {
  for (const Structure structure : kStructures)
    if (name == structure_code(structure)) return structure;
  return {};
}

}  // namespace glisson::atlas
