// SPDX-License-Identifier: GPL-3.0-or-later
// fuzz_write_seeds FOLDER: writes the files that fuzzing begins with into FOLDER/ENTRY.
#include <cstdio>
#include <fstream>

#include "entries.h"
#include "glisson/core/files.h"

int main(int count, char** words) {
  if (count != 2) {
    std::fprintf(stderr, "fuzz_write_seeds FOLDER\n");
    return 2;
  }
  for (const auto& [name, entry] : glisson::fuzz::all_entries()) {
    const std::filesystem::path folder = std::filesystem::path(words[1]) / name;
    std::filesystem::create_directories(folder);
    for (const auto& [file, bytes] : glisson::fuzz::seed_files(name))
      std::ofstream(folder / file, std::ios::binary) << bytes;
  }
  return 0;
}
