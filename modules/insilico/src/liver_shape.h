// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "implicit.h"

namespace glisson::insilico {

/// One member of the population. LPS millimetres; the origin lies in front of the spine at the hilum's level.
struct ShapeParameters {
  std::uint64_t seed = 1;
  double volume_ml = 1600;  ///< of the liver, aimed at by `size`
  double size = 1.0;        ///< common factor on the lobes' half axes
  double right_width = 76;  ///< half axes of the right lobe's dome
  double right_depth = 84;
  double right_height = 112;
  double left_width = 82;  ///< half axes of the left lobe's dome
  double left_depth = 52;
  double left_height = 64;
  double left_reach = 8;         ///< x of the left lobe's centre
  double saddle = 46;            ///< width of the blend between the two domes
  double slope_right = 0.50;     ///< rise of the visceral surface per mm to the left, right of the hilum
  double slope_left = 0.34;      ///< the same, left of it
  double slope_anterior = 0.36;  ///< fall of the visceral surface per mm to the front
  double hollow = 0.0022;        ///< its curvature from front to back, per mm
  double lift = 0;               ///< z of the visceral surface at the hilum
  double notch_x = 6;
  double notch_depth = 22;
  double bladder_x = -46;  ///< of the gallbladder's fundus
  double bladder_length = 62;
  double cava_radius = 11.5;
};

/// Draws a member of the population: deterministic in the seed, each parameter uniform between plausible
/// bounds (README), `size` solved so that the volume is as drawn.
ShapeParameters draw_shape(std::uint64_t seed);

/// A lesion: an ellipsoid with a slightly bumpy surface.
struct Lesion {
  Vec centre, half_axes;
  double bump = 0.06;  ///< relative height of the bumps
  double phase = 0.0;  ///< of the bumps
  double field(const Vec& p) const;
  double reach() const { return half_axes.maxCoeff() * (1.0 + bump); }
};

/// The trunk's width at a height, relative to that at the liver: it narrows towards the shoulders and the
/// waist.
inline double trunk_scale(double z) {
  return 1.0 - 0.11 * smooth_step(10.0, 190.0, z) - 0.045 * smooth_step(-10.0, -150.0, z);
}
/// An elliptic ring of the trunk with half axes rx, ry at the liver's height.
inline double trunk_ring(const Vec& p, double centre_y, double rx, double ry) {
  const double s = trunk_scale(p.z());
  return elliptic_cylinder(p.x(), p.y() - centre_y, s * rx, s * ry);
}

/// The liver as an implicit shape, and what it leans on. Immutable.
class LiverShape {
 public:
  explicit LiverShape(const ShapeParameters& parameters);

  const ShapeParameters& parameters() const { return parameters_; }

  double liver(const Vec& p) const;  ///< the filled organ, vessels and lesions included
  double dome(const Vec& p) const;   ///< both lobes' upper surface, without end below
  double cage(const Vec& p) const;   ///< inner wall of the trunk
  double cava(const Vec& p) const;   ///< vena cava, an endless tube
  double gallbladder(const Vec& p) const;
  double right_kidney(const Vec& p) const;
  double visceral_height(double x, double y) const;  ///< z of the lower surface
  Vec cava_centre(double z) const;
  Vec hilum() const { return hilum_; }
  Vec gradient(const Vec& p) const;  ///< of liver(), central differences
  /// The stretch of the vertical line at (x, y) inside the liver; empty (low > high) when there is none.
  std::pair<double, double> extent_at(double x, double y) const;
  /// A point inside the liver at (x, y), at the share s of the height there. If the line misses the liver, x
  /// and y are drawn towards its middle first.
  Vec point_inside(double x, double y, double s) const;
  Vec low() const { return {-145, -105, -105}; }
  Vec high() const { return {125, 105, 110}; }

  /// The ridge between the diaphragmatic and the visceral surface from the right flank to the left tip,
  /// ordered, about `spacing` mm apart, on the liver's surface.
  std::vector<Vec> anterior_margin(double spacing) const;
  /// The deepest point of the notch in the margin.
  Vec umbilical_notch() const;

 private:
  double lobes(const Vec& p) const;  ///< dome within the cage
  double upper(const Vec& p) const;  ///< lobes with the notch cut out
  double visceral(const Vec& p) const;
  Vec ridge_point(double angle, bool notched) const;
  Vec on_surface(Vec p) const;  ///< moved along the gradient until liver() is zero
  void place_notch();
  void place_gallbladder();

  ShapeParameters parameters_;
  Vec right_centre_, left_centre_, right_axes_, left_axes_;
  RoundCone notch_{}, bladder_{}, bladder_neck_{}, porta_{}, fissure_{};
  Vec hilum_;
};

/// Volume of {field < 0} inside the liver's box by sampling every `spacing` mm, millilitres.
double liver_volume_ml(const LiverShape& shape, double spacing);

}  // namespace glisson::insilico
