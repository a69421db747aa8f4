// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdlib>
#include <filesystem>
#include <utility>
#include <vector>

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

inline atlas::Atlas atlas_of_population(const atlas::BuildOptions& options, std::uint64_t livers) {
  std::vector<atlas::Member> members;
  for (std::uint64_t seed = 6101; seed < 6101 + livers; ++seed) members.push_back(synthetic_member(seed));
  return atlas::build(std::move(members), built_in(), options, RunContext())->atlas;
}

/// The same with structures where the population has them: the built-in one has some of them where real
/// livers do.
inline atlas::Atlas population_atlas() {
  atlas::BuildOptions options;
  options.name = "population";
  options.keep_shape = true;
  options.added_deviation = 0.018;
  options.added_unusual = 2.7;
  return atlas_of_population(options, 6);
}

/// One that knows how the population's structures depend on one another, and no single liver.
inline atlas::Atlas dependent_atlas() {
  atlas::BuildOptions options;
  options.name = "dependent";
  options.keep_shape = options.summed = true;
  return atlas_of_population(options, 8);
}

}  // namespace glisson::test
