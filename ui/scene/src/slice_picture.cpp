// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/scene/slice_picture.h"

#include <array>
#include <cmath>
#include <cstdio>

#include "glisson/core/error.h"
#include "glisson/patient/label_map.h"
#include "slice_layers.h"

namespace glisson::scene {

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
  if (labels != nullptr && !labels->empty()) {
    std::vector<Label> found(bytes->size() / 3, Label{0});
    const PixelBox all = PixelBox::all(geometry);
    sample_labels(*labels, geometry, all, found);
    blend_labels(found, geometry, style, all, *bytes);
  }
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
