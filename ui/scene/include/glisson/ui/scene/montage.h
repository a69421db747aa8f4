// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glisson/patient/picture.h"

namespace glisson::scene {

struct NamedPicture {
  std::string name;
  Picture picture;
};

/// Pictures of one size side by side, row by row, each with its name, to be compared.
/// @param scale of each picture, in (0, 1]. @pre there is one, all have the same size, columns is positive.
/// Text needs a QGuiApplication (see HeadlessGui).
Picture montage(const std::vector<NamedPicture>& pictures, int columns, double scale);

}  // namespace glisson::scene
