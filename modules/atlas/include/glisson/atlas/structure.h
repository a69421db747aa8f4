// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>

namespace glisson::atlas {

/// What the atlas knows a place for on the liver's surface.
enum class Structure {
  umbilical_notch,  ///< the deepest point of the notch in the margin
  falciform_line,   ///< from the notch over the dome to the vena cava's front
  anterior_margin,  ///< from the right lobe's tip past gallbladder and notch to the left lobe's end
  vena_cava,        ///< the middle of its contact, from below upwards
  portal_entrance,  ///< where the portal vein comes into the liver
  gallbladder_bed   ///< the middle of its bed, from the neck to the fundus
};

inline constexpr std::array<Structure, 6> kStructures = {
    Structure::umbilical_notch, Structure::falciform_line,  Structure::anterior_margin,
    Structure::vena_cava,       Structure::portal_entrance, Structure::gallbladder_bed};

/// How many ordered points a structure has, the same on every liver.
int point_count(Structure structure);
/// For files and figures: "umbilical_notch", ... Not translated.
const char* structure_code(Structure structure);
/// Of a structure_code(). Empty: no structure has this code.
std::optional<Structure> structure_of(const std::string& code);

}  // namespace glisson::atlas
