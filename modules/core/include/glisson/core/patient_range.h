// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace glisson {

/// How far from a scanner's origin, or from a camera, a coordinate of a patient may lie, metres, along each
/// axis. What is read and lies beyond is nowhere near a patient: the file is damaged, or in another unit.
inline constexpr double kPatientRange = 100.0;

}  // namespace glisson
