// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "dicom_bytes.h"

namespace glisson::test {

/// A DICOMDIR whose records name these files, each as its parts with backslashes between.
inline std::string dicomdir_of(const std::vector<std::string>& files) {
  std::string items;
  for (const std::string& file : files) {
    std::string item;
    put_element(item, "0004|1430", "CS", "IMAGE");
    if (!file.empty()) put_element(item, "0004|1500", "CS", file);
    put_number(items, 0xFFFE, 2);
    put_number(items, 0xE000, 2);
    put_number(items, static_cast<std::uint32_t>(item.size()), 4);
    items += item;
  }
  std::string bytes = file_beginning("1.2.840.10008.1.3.10", "1.2.826.0.1.3680043.2.1125.5");
  put_number(bytes, 0x0004, 2);
  put_number(bytes, 0x1220, 2);
  bytes += "SQ";
  put_number(bytes, 0, 2);
  put_number(bytes, static_cast<std::uint32_t>(items.size()), 4);
  return bytes + items;
}

}  // namespace glisson::test
