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

/// The same with structures where the population has them: the built-in one has some of them where real
/// livers do.
inline atlas::Atlas population_atlas() {
  std::vector<atlas::Member> members;
  for (std::uint64_t seed = 6101; seed < 6107; ++seed) members.push_back(synthetic_member(seed));
  atlas::BuildOptions options;
  options.name = "population";
  options.keep_shape = true;
  options.added_deviation = 0.018;
  options.added_unusual = 2.7;
  return atlas::build(std::move(members), built_in(), options, RunContext())->atlas;
}

}  // namespace glisson::test
