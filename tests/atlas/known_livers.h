// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdlib>
#include <filesystem>

#include "glisson/atlas/atlas.h"
#include "glisson/insilico/liver_population.h"

/// @file
/// Livers whose landmarks are known by formula, and the atlas that comes with the program.

namespace glisson::test {

inline insilico::PopulationLiver synthetic_liver(std::uint64_t seed, double spacing_mm) {
  return insilico::population_liver(seed, spacing_mm);
}

inline atlas::Member synthetic_member(std::uint64_t seed) {
  using atlas::Structure;
  const insilico::PopulationLiver liver = synthetic_liver(seed, 3.0);
  return {"liver_" + std::to_string(seed),
          liver.surface,
          {{Structure::umbilical_notch, liver.umbilical_notch},
           {Structure::falciform_line, liver.falciform_line},
           {Structure::anterior_margin, liver.anterior_margin},
           {Structure::vena_cava, liver.vena_cava},
           {Structure::portal_entrance, liver.portal_entrance},
           {Structure::gallbladder_bed, liver.gallbladder_bed}}};
}

inline atlas::Atlas built_in() {
  const char* source = std::getenv("GLISSON_SOURCE_DIR");
  return atlas::read_atlas(std::filesystem::path(source != nullptr ? source : ".") / "resources/atlas");
}

}  // namespace glisson::test
