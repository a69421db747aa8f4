// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "glisson/geometry/mesh.h"

namespace glisson::insilico {

/// The liver of one member of the population without its CT: the surface, and what lies where on it by
/// formula. CT frame, metres.
struct PopulationLiver {
  TriangleMesh surface;               ///< closed
  PointsIn<CtFrame> umbilical_notch;  ///< 1 x 3
  PointsIn<CtFrame> anterior_margin;  ///< ordered, from the right flank to the left tip
  PointsIn<CtFrame> falciform_line;   ///< ordered, from the notch over the dome to the vena cava's front
  PointsIn<CtFrame> vena_cava;        ///< the surface's vertices in the cava's groove
  PointsIn<CtFrame> portal_entrance;  ///< 1 x 3
  PointsIn<CtFrame> gallbladder_bed;  ///< the surface's vertices in the gallbladder's bed
};
/// The same liver as make_patient() has for this seed. @param spacing_mm between the surface's samples,
/// 0.5 to 20. @throws InputError the spacing
PopulationLiver population_liver(std::uint64_t shape_seed, double spacing_mm);

}  // namespace glisson::insilico
