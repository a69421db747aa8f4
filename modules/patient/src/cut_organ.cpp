// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/patient/cut_organ.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "glisson/core/error.h"
#include "glisson/volume/morphology.h"

namespace glisson {
namespace {

constexpr const char* kNote = "liver.cut_off ";
/// HU: padding is air or less. An image that was cut off at a higher value has it in lungs and fat, too.
constexpr std::int16_t kAir = -1000;
/// Where an image was resampled, a voxel between an organ and padding has something of both. One that is
/// thicker than this, mm, may as well be a body's wall.
constexpr double kBlurredMm = 2.5;

/// Voxels of the lowest value that reach the image's sides. @param is_lowest all voxels of that value.
std::vector<std::uint8_t> reaching_out(const VolumeGrid& grid, std::vector<std::uint8_t> is_lowest) {
  Mask mask(grid.size, grid.spacing_mm);
  mask.voxels = std::move(is_lowest);
  return complement(holes_filled(complement(std::move(mask)))).voxels;
}

/// Whether an organ's voxel lies at one that is set, or one blurred voxel before it.
EndsBetween at_set(const VolumeGrid& grid, const std::vector<std::uint8_t>& set) {
  const auto is_set = [&grid, &set](const Eigen::Vector3i& v) {
    return grid.contains(v) && set[static_cast<std::size_t>(grid.offset(v))] != 0;
  };
  return [&grid, is_set](const Eigen::Vector3i& here, const Eigen::Vector3i& next) {
    const Eigen::Vector3i step = next - here;
    const double thickness = grid.spacing_mm.dot(step.cwiseAbs().cast<double>());
    return is_set(next) || (thickness <= kBlurredMm && is_set(next + step));
  };
}

/// 0/1; empty: none that cuts the organ.
std::vector<std::uint8_t> padding_at(const std::vector<std::uint8_t>& organ, const Image& image) {
  const std::int16_t lowest = *std::ranges::min_element(*image.voxels);
  if (image.modality != Modality::ct || lowest > kAir) return {};
  std::vector<std::uint8_t> padding(organ.size());
  std::ranges::transform(*image.voxels, padding.begin(),
                         [lowest](std::int16_t value) { return value == lowest ? 1 : 0; });
  // Mostly it ends here: air has the lowest value, and touches no organ.
  if (area_mm2(image.grid, cut_rows(image.grid, organ, at_set(image.grid, padding))) < kLeastCutMm2)
    return {};
  return reaching_out(image.grid, std::move(padding));
}

}  // namespace

std::vector<CutRow> cut_rows(const VolumeGrid& grid, const std::vector<std::uint8_t>& organ,
                             const EndsBetween& ends_between) {
  require(static_cast<long>(organ.size()) == grid.voxel_count(), "an organ has the image's voxels");
  const auto is_organ = [&](const Eigen::Vector3i& v) {
    return organ[static_cast<std::size_t>(grid.offset(v))] != 0;
  };
  const auto is_cut = [&](const Eigen::Vector3i& here, const Eigen::Vector3i& step) {
    const Eigen::Vector3i next = here + step;
    return is_organ(here) && !(grid.contains(next) && is_organ(next)) && ends_between(here, next);
  };
  const VoxelBox box = bounding_box(grid.size, grid.spacing_mm, organ, 0.0);
  std::vector<CutRow> rows;
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (const bool high : {false, true}) {
      const Eigen::Vector3i step = (high ? 1 : -1) * Eigen::Vector3i::Unit(axis);
      Eigen::Vector3i at;
      for (at[axis] = box.low[axis]; at[axis] < box.high[axis]; ++at[axis])
        for (at[v] = box.low[v]; at[v] < box.high[v]; ++at[v]) {
          bool was_cut = false;
          for (at[u] = box.low[u]; at[u] < box.high[u]; ++at[u]) {
            const bool is_cut_here = is_cut(at, step);
            if (is_cut_here && !was_cut) rows.push_back({axis, high, at, 0});
            if (is_cut_here) ++rows.back().count;
            was_cut = is_cut_here;
          }
        }
    }
  }
  return rows;
}

std::vector<CutRow> image_cut(const VolumeGrid& grid, const std::vector<std::uint8_t>& organ,
                              const Image* image) {
  require(image == nullptr || image->voxels->size() == organ.size(), "an organ has the image's voxels");
  const std::vector<std::uint8_t> padding =
      image == nullptr ? std::vector<std::uint8_t>() : padding_at(organ, *image);
  const EndsBetween at_padding = at_set(grid, padding);
  return cut_rows(grid, organ, [&](const Eigen::Vector3i& here, const Eigen::Vector3i& next) {
    return !grid.contains(next) || (!padding.empty() && at_padding(here, next));
  });
}

double area_mm2(const VolumeGrid& grid, const std::vector<CutRow>& rows) {
  double area = 0.0;
  for (const CutRow& row : rows)
    area += row.count * grid.spacing_mm[(row.axis + 1) % 3] * grid.spacing_mm[(row.axis + 2) % 3];
  return area;
}

std::optional<std::string> cut_note(const VolumeGrid& grid, const std::vector<CutRow>& liver_cut) {
  const double area = area_mm2(grid, liver_cut);
  if (area < kLeastCutMm2) return std::nullopt;
  return kNote + std::to_string(std::lround(1e-2 * area));
}

long told_cut(const std::vector<std::string>& notes) {
  for (const std::string& note : notes)
    if (note.starts_with(kNote)) return std::strtol(note.c_str() + std::strlen(kNote), nullptr, 10);
  return 0;
}

}  // namespace glisson
