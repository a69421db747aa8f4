// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/fem/materials.h"

#include <algorithm>
#include <array>

#include "glisson/core/error.h"

namespace glisson::fem {
namespace {

struct Preset {
  std::string_view name;
  double young_modulus;  ///< of the parenchyma, Pa
  bool is_homogeneous;
};
constexpr std::array<Preset, 4> kPresets = {{{"healthy", 3.5e3, false},
                                             {"healthy_homogeneous", 3.5e3, true},
                                             {"cirrhotic", 30e3, false},
                                             {"cirrhotic_homogeneous", 30e3, true}}};

}  // namespace

std::vector<std::string> composite_preset_names() {
  std::vector<std::string> names;
  for (const Preset& preset : kPresets) names.emplace_back(preset.name);
  return names;
}

CompositeOptions composite_preset(std::string_view name) {
  const auto preset =
      std::find_if(kPresets.begin(), kPresets.end(), [&](const Preset& one) { return one.name == name; });
  if (preset == kPresets.end()) {
    std::string known;
    for (const Preset& one : kPresets) known += (known.empty() ? "" : ", ") + std::string(one.name);
    throw InputError("material preset", std::string(name), "is not known", "Take one of " + known);
  }
  CompositeOptions options;
  options.parenchyma.young_modulus = preset->young_modulus;
  if (preset->is_homogeneous) options.with_capsule = options.with_vessels = false;
  return options;
}

}  // namespace glisson::fem
