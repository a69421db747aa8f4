// SPDX-License-Identifier: GPL-3.0-or-later
#include "entries.h"
#include "picture_header.h"
#include "scratch.h"

namespace glisson::fuzz {

void picture_header(std::string_view bytes) {
  if (const auto header = stereo::picture_header(bytes))
    must(header->width > 0 && header->height > 0, "a picture without a side");
}

}  // namespace glisson::fuzz
