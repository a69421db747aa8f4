// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace glisson {

/// 95 % of chi-square with three degrees of freedom: the squared Mahalanobis distance within which a normal
/// error in space lies in 95 of 100 cases.
inline constexpr double kEllipsoid95 = 7.8147;

}  // namespace glisson
