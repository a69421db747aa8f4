// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

namespace glisson {

enum class Wrapper { gzip, zlib };

/// Deflates `size` bytes. The same bytes in give the same bytes out (no time stamp).
std::string compressed(const void* data, std::size_t size, Wrapper wrapper);

}  // namespace glisson
