// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

#include "glisson/core/units.h"
#include "glisson/engine/command.h"
#include "glisson/fem/composite_model.h"
#include "glisson/fem/loads_io.h"
#include "glisson/fem/simulate.h"

namespace glisson::engine {

/// Plain mechanics on the model, from its rest shape. Changes no part: writes step_00001.vtu ...
/// (displacement_mm, von_mises_pa) and steps.csv into `folder`, which exists.
struct Simulate {
  fem::LoadCase load;
  fem::SimulationOptions options;
  /// Empty: the healthy liver, its parenchyma as stiff as the case says. Lesions are as the case says.
  std::optional<fem::CompositeOptions> materials = {};
  std::optional<fem::TetrahedronLaw> law = {};  ///< over that of the materials
  std::filesystem::path folder;
  LengthUnit unit = LengthUnit::millimetre;  ///< of the meshes
  int every = 1;                             ///< write every so many steps, and the last

  CommandTraits traits() const;
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
