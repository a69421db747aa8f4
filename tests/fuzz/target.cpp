// SPDX-License-Identifier: GPL-3.0-or-later
// A libFuzzer target of one reader: GLISSON_FUZZ_ENTRY names it.
#include <cstddef>
#include <cstdint>

#include "entries.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  glisson::fuzz::GLISSON_FUZZ_ENTRY({reinterpret_cast<const char*>(data), size});
  return 0;
}
