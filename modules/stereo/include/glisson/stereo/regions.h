// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <vector>

#include "glisson/patient/labelled_cloud.h"

namespace glisson::stereo {

/// A closed polygon that the operator clicked on the left image; points in it get its feature. Pixel
/// coordinates of the distorted left image. Overlaps: notch over margin over surface.
struct Region {
  Feature feature = Feature::surface;
  std::vector<Eigen::Vector2d> polygon;
};
/// JSON {"image": "left", "frame": 0, "regions": [{"label": "surface", "polygon": [[x, y], ...]}, ...]}
struct Regions {
  int frame = 0;
  std::vector<Region> regions;
};

/// @throws FileError; InputError naming the region and what is wrong: no label or one that is none, a polygon
///   of fewer than three vertices, a number that is none.
Regions read_regions(const std::filesystem::path& path);
/// Atomic. @pre every polygon has three finite vertices or more.
void write_regions(const std::filesystem::path& path, const Regions& regions);

/// What the pixel shows; empty: it lies in no region. Even-odd rule.
std::optional<Feature> feature_at(const Regions& regions, const Eigen::Vector2d& pixel);

}  // namespace glisson::stereo
