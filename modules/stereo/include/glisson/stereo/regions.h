// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "glisson/patient/labelled_cloud.h"
#include "glisson/patient/picture.h"
#include "glisson/stereo/side.h"

namespace glisson::stereo {

/// A closed polygon, or an open curve (the margin as a line), that the operator clicked on one of the two
/// pictures; points in it, or near it, get its feature. Pixel coordinates of the picture as taken
/// (distorted). Overlaps: notch over margin over surface.
struct Region {
  Feature feature = Feature::surface;
  std::vector<Eigen::Vector2d> polygon;  ///< vertices of the polygon, or of the curve
  bool closed = true;                    ///< false: a curve
  double half_width_px = 6.0;            ///< of a curve: how far from it its feature reaches; > 0
  Side side = Side::left;                ///< of which picture these pixels are

  /// Vertices that such a region needs: 3, a curve 2.
  std::size_t fewest_vertices() const { return closed ? 3 : 2; }
};

/// What was clicked on one frame.
///   {"image": "left", "frame": 0, "identity": "90a1...", "regions": [
///     {"label": "surface", "polygon": [[x, y], ...]},
///     {"label": "anterior_margin", "curve": [[x, y], ...], "half_width_px": 6, "image": "right"}, ...]}
/// Files without "identity" and with polygons only, as earlier versions wrote them, are read too.
struct Regions {
  int frame = 0;
  std::string identity;  ///< frame_identity() of the frame they belong to; empty: not known
  std::vector<Region> regions;
};

/// @throws FileError; InputError naming the region and what is wrong: no label or one that is none, a polygon
///   of fewer than three vertices, a curve of fewer than two, a number that is none, an unknown picture.
Regions read_regions(const std::filesystem::path& path);
/// Atomic. @pre every polygon has three finite vertices or more, every curve two and a positive width.
void write_regions(const std::filesystem::path& path, const Regions& regions);

/// What tells one frame from every other: 16 hexadecimal digits computed from the size and every byte of both
/// pictures (not from its number, which another video has too). Survives lossless files.
std::string frame_identity(const Picture& left, const Picture& right);
/// @throws InputError when the regions say that they belong to another frame than this one.
void require_regions_of(const Regions& regions, const Picture& left, const Picture& right);

/// Whether a pixel lies inside the polygon (even-odd rule), or within the half width of the curve.
bool contains(const Region& region, const Eigen::Vector2d& pixel);
/// What the pixel shows; empty: it lies in no region of its picture.
std::optional<Feature> feature_at(const Regions& regions, Side side, const Eigen::Vector2d& pixel);
/// The same for the left picture.
std::optional<Feature> feature_at(const Regions& regions, const Eigen::Vector2d& pixel);

/// Where on a region's outline something is.
struct OutlinePlace {
  std::size_t edge = 0;  ///< from vertex `edge` to the next (of a polygon: the first after the last)
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
  double distance_px = 0.0;
};
/// The place of the outline that is closest to a pixel (where a click on the line puts a new vertex:
/// after `edge`). @pre a vertex or more.
OutlinePlace closest_on_outline(const Region& region, const Eigen::Vector2d& pixel);
/// Whether two edges cross: such a polygon does not enclose what it seems to.
bool crosses_itself(const Region& region);

}  // namespace glisson::stereo
