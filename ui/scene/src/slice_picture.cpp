// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/scene/slice_picture.h"

#include <array>
#include <cmath>
#include <cstdio>

#include "glisson/core/error.h"
#include "glisson/patient/label_map.h"

namespace glisson::scene {
namespace {

/// Walks a slice in voxel coordinates, which are affine in the pixel.
struct VoxelWalk {
  Eigen::Vector3d start, right, down;
  VoxelWalk(const VolumeGrid& grid, const SliceGeometry& slice)
      : start(grid.index_of(slice.p_in_ct({0.0, 0.0}))),
        right(grid.index_of(slice.p_in_ct({1.0, 0.0})) - start),
        down(grid.index_of(slice.p_in_ct({0.0, 1.0})) - start) {}
  Eigen::Vector3d at(int u, int v) const { return start + u * right + v * down; }
};

/// Trilinear value; false outside. Half a voxel beyond the outermost centres still belongs to the volume.
bool interpolate(const Image& image, const Eigen::Vector3d& index, double& value) {
  const Eigen::Vector3i& size = image.grid.size;
  std::array<int, 3> low{};
  std::array<int, 3> high{};
  std::array<double, 3> t{};
  for (int k = 0; k < 3; ++k) {
    const auto i = static_cast<std::size_t>(k);
    if (index[k] < -0.5 || index[k] > size[k] - 0.5) return false;
    const double x = std::clamp(index[k], 0.0, size[k] - 1.0);
    low[i] = static_cast<int>(x);
    high[i] = std::min(low[i] + 1, size[k] - 1);
    t[i] = x - low[i];
  }
  const std::int16_t* voxels = image.voxels->data();
  const auto row = [&](int y, int z) {
    const long base = static_cast<long>(size.x()) * (y + static_cast<long>(size.y()) * z);
    return (1.0 - t[0]) * voxels[base + low[0]] + t[0] * voxels[base + high[0]];
  };
  const auto layer = [&](int z) { return (1.0 - t[1]) * row(low[1], z) + t[1] * row(high[1], z); };
  value = (1.0 - t[2]) * layer(low[2]) + t[2] * layer(high[2]);
  return true;
}

void draw_grey(const Image& image, const SliceGeometry& slice, const SliceStyle& style,
               std::vector<std::uint8_t>& bytes) {
  const VoxelWalk walk(image.grid, slice);
  const double low = style.level - 0.5 * style.width, scale = 255.0 / style.width;
  std::size_t at = 0;
  for (int v = 0; v < slice.height; ++v)
    for (int u = 0; u < slice.width; ++u, at += 3) {
      double value = 0.0;
      if (!interpolate(image, walk.at(u, v), value)) continue;
      const auto grey = static_cast<std::uint8_t>(std::clamp((value - low) * scale + 1e-9, 0.0, 255.0));
      bytes[at] = bytes[at + 1] = bytes[at + 2] = grey;
    }
}

std::vector<Label> labels_on(const LabelVolume& labels, const SliceGeometry& slice) {
  const VoxelWalk walk(labels.grid(), slice);
  std::vector<Label> found(static_cast<std::size_t>(slice.width) * static_cast<std::size_t>(slice.height), 0);
  std::size_t at = 0;
  for (int v = 0; v < slice.height; ++v)
    for (int u = 0; u < slice.width; ++u, ++at) {
      const Eigen::Vector3i voxel = walk.at(u, v).array().round().cast<int>().matrix();
      if (labels.grid().contains(voxel)) found[at] = labels.at(voxel);
    }
  return found;
}

void draw_labels(const std::vector<Label>& labels, const SliceGeometry& slice, double opacity,
                 std::vector<std::uint8_t>& bytes) {
  const auto width = static_cast<std::size_t>(slice.width);
  for (std::size_t at = 0; at < labels.size(); ++at) {
    const Label label = labels[at];
    if (label == structure::kBackground) continue;
    const std::size_t u = at % width;
    const bool edge = (u > 0 && labels[at - 1] != label) || (u + 1 < width && labels[at + 1] != label) ||
                      (at >= width && labels[at - width] != label) ||
                      (at + width < labels.size() && labels[at + width] != label);
    const auto rgb = structure_colour(label);
    const double alpha = edge ? 0.95 : opacity;
    for (std::size_t c = 0; c < 3; ++c)
      bytes[3 * at + c] =
          static_cast<std::uint8_t>((1.0 - alpha) * bytes[3 * at + c] + alpha * 255.0 * rgb[2 - c]);
  }
}

}  // namespace

EdgeLetters edge_letters(Plane plane) {
  switch (plane) {
    case Plane::axial:
      return {'R', 'L', 'A', 'P'};
    case Plane::coronal:
      return {'R', 'L', 'S', 'I'};
    case Plane::sagittal:
      return {'A', 'P', 'S', 'I'};
  }
  return {};
}

int normal_axis(Plane plane) { return plane == Plane::axial ? 2 : plane == Plane::coronal ? 1 : 0; }

VolumeBox bounding_box(const VolumeGrid& grid) {
  VolumeBox box{grid.p_in_ct(Eigen::Vector3d::Zero()).xyz, grid.p_in_ct(Eigen::Vector3d::Zero()).xyz};
  for (int corner = 1; corner < 8; ++corner) {
    Eigen::Vector3d index = Eigen::Vector3d::Zero();
    for (int k = 0; k < 3; ++k)
      if ((corner >> k) & 1) index[k] = grid.size[k] - 1;
    const Eigen::Vector3d p = grid.p_in_ct(index).xyz;
    box.low = box.low.cwiseMin(p);
    box.high = box.high.cwiseMax(p);
  }
  return box;
}

SliceGeometry slice_geometry(const VolumeGrid& grid, Plane plane, const Point<CtFrame>& through) {
  require(grid.voxel_count() > 0, "a slice is cut from a volume that has voxels");
  const VolumeBox box = bounding_box(grid);
  const double step = 1e-3 * grid.spacing_mm.minCoeff();
  SliceGeometry slice;
  slice.plane = plane;
  // LPS: +x to the patient's left, +y to posterior, +z up. Left of the picture is the patient's right, or
  // anterior in a sagittal slice.
  const int across = plane == Plane::sagittal ? 1 : 0, along = plane == Plane::axial ? 1 : 2;
  slice.right = step * Eigen::Vector3d::Unit(across);
  slice.down = (along == 2 ? -step : step) * Eigen::Vector3d::Unit(along);
  slice.origin[across] = box.low[across];
  slice.origin[along] = along == 2 ? box.high[along] : box.low[along];
  slice.origin[normal_axis(plane)] = through.xyz[normal_axis(plane)];
  slice.width = static_cast<int>(std::floor((box.high[across] - box.low[across]) / step + 1e-6)) + 1;
  slice.height = static_cast<int>(std::floor((box.high[along] - box.low[along]) / step + 1e-6)) + 1;
  return slice;
}

Picture slice_picture(const Image& image, const LabelVolume* labels, const SliceGeometry& geometry,
                      const SliceStyle& style) {
  require(!image.empty(), "a slice is cut from an image that has voxels");
  if (!(style.width > 0.0))
    throw InputError("slice style", "width", "is " + std::to_string(style.width),
                     "Give a window width above 0.");
  auto bytes = std::make_shared<std::vector<std::uint8_t>>(
      3 * static_cast<std::size_t>(geometry.width) * static_cast<std::size_t>(geometry.height),
      std::uint8_t{0});
  draw_grey(image, geometry, style, *bytes);
  if (labels != nullptr && !labels->empty())
    draw_labels(labels_on(*labels, geometry), geometry, style.label_opacity, *bytes);
  return {geometry.width, geometry.height, 3, bytes};
}

Probe probe(const Image& image, const LabelVolume* labels, const Point<CtFrame>& p) {
  Probe found;
  if (!image.empty()) {
    const Eigen::Vector3i voxel = image.grid.index_of(p).array().round().cast<int>().matrix();
    found.inside = image.grid.contains(voxel);
    if (found.inside) found.value = image.at(voxel);
  }
  if (labels != nullptr && !labels->empty()) {
    const Eigen::Vector3i voxel = labels->grid().index_of(p).array().round().cast<int>().matrix();
    if (labels->grid().contains(voxel)) found.label = labels->at(voxel);
  }
  return found;
}

std::string anatomical_coordinate(int axis, double metres_lps) {
  require(axis >= 0 && axis < 3, "an anatomical axis is 0, 1 or 2");
  static constexpr std::array<std::array<char, 2>, 3> kLetters = {{{'R', 'L'}, {'A', 'P'}, {'I', 'S'}}};
  const double mm = 1e3 * metres_lps;
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%c %.1f",
                kLetters[static_cast<std::size_t>(axis)][std::abs(mm) < 0.05 || mm > 0.0 ? 1 : 0],
                std::abs(mm));
  return text.data();
}

}  // namespace glisson::scene
