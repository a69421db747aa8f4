// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// @file
/// What a recovery folder holds.

namespace glisson::engine {

inline constexpr const char* kCopyName = "copy.glisson";
inline constexpr const char* kSaidName = "copy.json";  ///< of which case it is, and from when

}  // namespace glisson::engine
