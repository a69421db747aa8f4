// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace glisson {

/// Values that one volume may hold: 512 x 512 x 2000 of a whole body are 5e8. The program that reads foreign
/// files refuses more, and what it leaves is held to the same.
constexpr double kMostVolumeValues = 6e8;

}  // namespace glisson
