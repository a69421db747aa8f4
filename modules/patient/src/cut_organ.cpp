// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/patient/cut_organ.h"

#include <cmath>
#include <cstdlib>
#include <cstring>

#include "glisson/core/error.h"

namespace glisson {
namespace {

constexpr const char* kNote = "liver.cut_off ";

}  // namespace

double cut_area_mm2(const VolumeGrid& grid, const std::vector<std::uint8_t>& organ) {
  const Eigen::Vector3i& size = grid.size;
  require(organ.size() == static_cast<std::size_t>(size.cast<long>().prod()),
          "an organ has the image's voxels");
  double area = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const double face = grid.spacing_mm[u] * grid.spacing_mm[v];
    for (const int side : {0, size[axis] - 1}) {
      Eigen::Vector3i at;
      at[axis] = side;
      for (at[u] = 0; at[u] < size[u]; ++at[u])
        for (at[v] = 0; at[v] < size[v]; ++at[v])
          area += organ[static_cast<std::size_t>(grid.offset(at))] != 0 ? face : 0.0;
    }
  }
  return area;
}

std::optional<std::string> cut_note(const VolumeGrid& grid, const std::vector<std::uint8_t>& liver) {
  const double area = cut_area_mm2(grid, liver);
  if (area < kLeastCutMm2) return std::nullopt;
  return kNote + std::to_string(std::lround(1e-2 * area));
}

long told_cut(const std::vector<std::string>& notes) {
  for (const std::string& note : notes)
    if (note.starts_with(kNote)) return std::strtol(note.c_str() + std::strlen(kNote), nullptr, 10);
  return 0;
}

}  // namespace glisson
