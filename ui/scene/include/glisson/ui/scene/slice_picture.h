// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <vector>

#include "glisson/core/frames.h"
#include "glisson/patient/picture.h"
#include "glisson/volume/image.h"
#include "glisson/volume/label_volume.h"

namespace glisson::scene {

/// The patient's anatomical planes, whatever the scanner's axes were.
enum class Plane { axial, coronal, sagittal };

/// Letters at the edges of a slice, as radiologists expect them (the patient's right is on the left).
struct EdgeLetters {
  char left = 'R', right = 'L', top = 'A', bottom = 'P';
};
EdgeLetters edge_letters(Plane plane);

/// Where the pixels of a slice lie. Pixels are square, as fine as the volume's finest spacing.
struct SliceGeometry {
  Plane plane = Plane::axial;
  int width = 0, height = 0;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< CT frame, metres; centre of pixel (0, 0)
  Eigen::Vector3d right = Eigen::Vector3d::UnitX();  ///< metres per pixel
  Eigen::Vector3d down = Eigen::Vector3d::UnitY();   ///< metres per pixel

  Point<CtFrame> p_in_ct(const Eigen::Vector2d& pixel) const {
    return Point<CtFrame>(origin + pixel.x() * right + pixel.y() * down);
  }
  /// Of a point's foot on the slice.
  Eigen::Vector2d pixel_of(const Point<CtFrame>& p) const {
    const Eigen::Vector3d d = p.xyz - origin;
    return {d.dot(right) / right.squaredNorm(), d.dot(down) / down.squaredNorm()};
  }
  /// Signed distance of a point from the slice, metres.
  double distance_of(const Point<CtFrame>& p) const {
    return (p.xyz - origin).dot(right.cross(down).normalized());
  }
};
/// The slice of the whole volume through a point. @pre the grid has voxels.
SliceGeometry slice_geometry(const VolumeGrid& grid, Plane plane, const Point<CtFrame>& through);

/// The box around a volume along the patient's axes. CT frame, metres; voxel centres.
struct VolumeBox {
  Eigen::Vector3d low, high;
};
VolumeBox bounding_box(const VolumeGrid& grid);
/// Which CT axis a plane steps along: axial z, coronal y, sagittal x.
int normal_axis(Plane plane);

struct SliceStyle {
  double level = 80.0, width = 400.0;  ///< grey window, in the image's units (HU)
  double label_opacity = 0.35;         ///< inside; a label's edge is always drawn
  std::vector<Label> hidden{};         ///< labels that are not drawn
  double slab = 0.0;                   ///< metres over which the brightest is shown; 0: the slice alone
  bool hides(Label label) const { return std::find(hidden.begin(), hidden.end(), label) != hidden.end(); }
};
/// The volume on a slice (trilinear), or the brightest of a slab about it, with the slice's labels over it
/// (nearest voxel, structure colours). Outside the volume it is black. @param labels may be null or empty; of
/// any grid. @throws InputError window width not positive.
Picture slice_picture(const Image& image, const LabelVolume* labels, const SliceGeometry& geometry,
                      const SliceStyle& style);

/// What lies at a point.
struct Probe {
  bool inside = false;  ///< the image
  double value = 0.0;   ///< HU of the closest voxel
  Label label = 0;
};
Probe probe(const Image& image, const LabelVolume* labels, const Point<CtFrame>& p);

/// A coordinate for people: 12.3 mm to the patient's Left of the origin is "L 12.3". `axis` 0: R/L, 1: A/P,
/// 2: I/S.
std::string anatomical_coordinate(int axis, double metres_lps);

}  // namespace glisson::scene
