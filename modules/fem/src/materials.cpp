// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/fem/materials.h"

#include "glisson/core/error.h"

namespace glisson::fem {

std::vector<std::string> composite_preset_names() {
  return {"healthy", "healthy_homogeneous", "cirrhotic", "cirrhotic_homogeneous"};
}

CompositeOptions composite_preset(std::string_view name) {
  CompositeOptions options;  // healthy
  std::string known;
  for (const std::string& candidate : composite_preset_names()) {
    known += (known.empty() ? "" : ", ") + candidate;
    if (candidate != name) continue;
    if (name.starts_with("cirrhotic")) options.parenchyma.young_modulus = 30e3;
    if (name.ends_with("_homogeneous")) options.with_capsule = options.with_vessels = false;
    return options;
  }
  throw InputError("material preset", std::string(name), "is not known", "Take one of " + known);
}

double spring_stiffness(double young_modulus, double area, double length) {
  if (!(young_modulus > 0.0 && area > 0.0 && length > 0.0))
    throw InputError("spring", "E, A or L", "is not positive",
                     "Give Young's modulus in Pa, the section in m2 and the length in m, all above 0");
  return young_modulus * area / length;
}

}  // namespace glisson::fem
