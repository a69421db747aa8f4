// SPDX-License-Identifier: GPL-3.0-or-later
// fuzz_volumes COUNT: damages good volumes COUNT times a format, has them read by the program that reads
// volumes, and prints a table: what was refused, in how many of these that program broke down, what was read
// with the same voxels and place, and what was read as something else.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <random>

#include "damage.h"
#include "dicom_bytes.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/volume/io.h"
#include "phantom.h"

namespace {

using namespace glisson;
namespace fs = std::filesystem;

struct Tally {
  int refused = 0, broken = 0, same = 0, other_voxels = 0, other_place = 0;
  double longest = 0.0;
};

void read(const fs::path& path, const Image& good, Tally& tally) {
  const auto begin = std::chrono::steady_clock::now();
  try {
    const Image image = read_image(path, RunContext()).value();
    if (!image.grid.same_as(good.grid))
      ++tally.other_place;
    else
      ++(*image.voxels == *good.voxels ? tally.same : tally.other_voxels);
  } catch (const Error& error) {
    ++tally.refused;
    tally.broken += std::string(error.what()).find("broke down") != std::string::npos;
  }
  tally.longest = std::max(tally.longest,
                           std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
}

void write(const fs::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
}

std::string vti() {
  std::string values;
  for (int n = 0; n < 60; ++n) values += std::to_string(n * 17 % 900 - 500) + " ";
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
         "<ImageData WholeExtent=\"0 4 0 3 0 2\" Origin=\"1 2 3\" Spacing=\"1 1 2\">\n<Piece Extent=\"0 4 0 "
         "3 0 2\">\n"
         "<PointData Scalars=\"s\"><DataArray type=\"Int16\" Name=\"s\" format=\"ascii\">" +
         values + "</DataArray></PointData>\n</Piece>\n</ImageData>\n</VTKFile>\n";
}

Tally run(const std::string& name, int count) {
  const TemporaryFolder folder;
  const bool series = name == "dicom";
  const fs::path path = series ? folder.path() / "series" : folder.path() / name;
  fs::path victim = path;
  if (series) {
    fs::create_directory(path);
    for (int k = 0; k < 4; ++k) write(path / std::to_string(k), test::dicom_of(k, test::HandSlice()));
    victim = path / "2";
  } else if (name == "a.vti") {
    write(path, vti());
  } else {
    write_image(path, test::stored_world(11));
  }
  const Image good = read_image(path, RunContext()).value();
  const std::string bytes = read_file(victim);
  std::mt19937 random(41);
  Tally tally;
  for (int n = 0; n < count; ++n) {
    write(victim, fuzz::damaged(bytes, random));
    read(path, good, tally);
  }
  return tally;
}

}  // namespace

int main(int count, char** words) {
  if (count != 2) {
    std::fprintf(stderr, "fuzz_volumes COUNT\n");
    return 2;
  }
  std::printf(
      "| format | damaged | refused | of these, reader ended | same image | other voxels | other place | "
      "longest |\n"
      "|---|---|---|---|---|---|---|---|\n");
  for (const char* name : {"a.nrrd", "a.nii", "a.nii.gz", "a.mha", "a.vti", "dicom"}) {
    const Tally tally = run(name, std::atoi(words[1]));
    std::printf("| %s | %s | %d | %d | %d | %d | %d | %.1f s |\n", name, words[1], tally.refused,
                tally.broken, tally.same, tally.other_voxels, tally.other_place, tally.longest);
    std::fflush(stdout);
  }
  return 0;
}
