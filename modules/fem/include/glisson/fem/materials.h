// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "glisson/fem/composite_model.h"

namespace glisson::fem {

/// Names that composite_preset() knows: "healthy" (paper, 3.2: parenchyma 3.5 kPa / 0.45, vessels 620 kPa /
/// 0.4, capsule 8000 kPa / 0.45), "cirrhotic" (parenchyma 30 kPa, the rest alike), and each with
/// "_homogeneous" (parenchyma alone).
std::vector<std::string> composite_preset_names();
/// @throws InputError for an unknown name, listing those there are.
CompositeOptions composite_preset(std::string_view name);

}  // namespace glisson::fem
