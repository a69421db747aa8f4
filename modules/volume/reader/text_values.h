// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "raw_volume.h"

namespace glisson::reader {

/// A format of numbers, as the header of a volume of text names it.
struct NumberType {
  int bytes = 0;
  bool is_signed = true, is_whole = true;
};

/// Refuses voxels written as text that the libraries cut, wrap or pass over: more or fewer than `count`, no
/// numbers, beyond what their type holds. Blanks and commas lie between them.
/// @throws InputError naming the field.
void check_text_values(const Request& request, const std::string& field, std::string_view text, double count,
                       const NumberType& type);

}  // namespace glisson::reader
