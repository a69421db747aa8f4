// SPDX-License-Identifier: GPL-3.0-or-later
#include "liver_shape.h"

#include "glisson/core/run_context.h"

namespace glisson::insilico {

namespace {

/// Where the visceral surface's tilt changes: the hilum's place seen from below.
constexpr double kHilumX = -16.0, kHilumY = -6.0;

/// A dome: a full ellipsoid above its equator, a straight wall below (so that the wall meets the visceral
/// surface at a sharp angle). The exponent makes the top broader than an ellipsoid's.
class Dome {
 public:
  Dome(const Vec& p, const Vec& centre, const Vec& axes) : far_inside_(-axes.minCoeff()) {
    const Vec d = p - centre;
    plan_ = length(d.x() / axes.x(), d.y() / axes.y());
    rise_ = soft_ramp(d.z(), 14.0) / axes.z();
    k1_ = Vec(d.x() / (axes.x() * axes.x()), d.y() / (axes.y() * axes.y()), rise_ / axes.z()).norm();
  }
  double field() const {
    constexpr double kPower = 2.35;
    const double more = std::max(plan_, rise_);
    // The norm (plan^q + rise^q)^(1/q), with a power less.
    return at(more * std::pow(1.0 + std::pow(std::min(plan_, rise_) / more, kPower), 1.0 / kPower));
  }
  /// No more than that, without a power: no norm is less than its largest term.
  double at_least() const { return at(std::max(plan_, rise_)); }

 private:
  double at(double k0) const { return k1_ < 1e-9 ? far_inside_ : length(plan_, rise_) * (k0 - 1.0) / k1_; }

  double far_inside_, plan_, rise_, k1_;
};

}  // namespace

double Lesion::field(const Vec& p) const {
  const Vec d = p - centre;
  const Vec u = d.normalized();
  const double bumps = std::sin(3.0 * u.x() + phase) * std::cos(4.0 * u.y() + 2.0 * phase) +
                       0.6 * std::sin(5.0 * u.z() - phase + 2.0 * u.x());
  return ellipsoid(d, half_axes) - (d.norm() < 1e-9 ? 0.0 : 0.6 * bump * half_axes.minCoeff() * bumps);
}

LiverShape::LiverShape(const ShapeParameters& parameters) : parameters_(parameters) {
  const ShapeParameters& s = parameters_;
  right_axes_ = s.size * Vec(s.right_width, s.right_depth, s.right_height);
  left_axes_ = s.size * Vec(s.left_width, s.left_depth, s.left_height);
  // The right lobe leans on the right flank whatever its size; both lobes on the anterior wall.
  right_centre_ = {-135.0 + right_axes_.x(), -91.0 + right_axes_.y(), -24.0};
  left_centre_ = {s.left_reach, -93.0 + left_axes_.y() + 4.0, -2.0};
  hilum_ = {kHilumX, kHilumY, visceral_height(kHilumX, kHilumY)};
  porta_ = {hilum_ + Vec(-16, 4, -5), hilum_ + Vec(18, -8, -1), 7.0, 6.0};
  // Off everywhere until placed: a cone far away.
  const Vec nowhere(0, 0, -1e4);
  notch_ = bladder_ = bladder_neck_ = fissure_ = {nowhere, nowhere, 1.0, 1.0};
  place_notch();
  place_gallbladder();
}

double LiverShape::cage(const Vec& p) const { return trunk_ring(p, 1.0, 139.0, 97.0); }

double LiverShape::dome(const Vec& p) const {
  const Dome right(p, right_centre_, right_axes_), left(p, left_centre_, left_axes_);
  const bool is_right = right.at_least() < left.at_least();
  const double near = (is_right ? right : left).field();
  const Dome& other = is_right ? left : right;
  // Beyond the saddle's width the other has no part in the minimum.
  return other.at_least() - near > parameters_.saddle ? near
                                                      : smooth_min(near, other.field(), parameters_.saddle);
}

double LiverShape::lobes(const Vec& p) const { return smooth_max(dome(p), cage(p) + 1.5, 14.0); }

double LiverShape::upper(const Vec& p) const { return smooth_max(lobes(p), -notch_(p), 8.0); }

double LiverShape::visceral_height(double x, double y) const {
  const ShapeParameters& s = parameters_;
  const double dx = x - kHilumX, dy = y - kHilumY;
  return s.lift + s.slope_left * soft_ramp(dx, 30.0) - s.slope_right * soft_ramp(-dx, 30.0) +
         0.06 * soft_ramp(dy, 40.0) - s.slope_anterior * soft_ramp(-dy, 40.0) - s.hollow * dy * dy -
         0.0007 * dx * dx;
}

double LiverShape::visceral(const Vec& p) const {
  constexpr double h = 0.5;
  const double z = visceral_height(p.x(), p.y());
  const double gx = (visceral_height(p.x() + h, p.y()) - z) / h;
  const double gy = (visceral_height(p.x(), p.y() + h) - z) / h;
  return (z - p.z()) / std::sqrt(1.0 + gx * gx + gy * gy);
}

Vec LiverShape::cava_centre(double z) const {
  return {-22.0 + 8.0 * smooth_step(40, 105, z), 31.0 - 20.0 * smooth_step(15, 100, z), z};
}

double LiverShape::cava(const Vec& p) const {
  const Vec c = cava_centre(p.z());
  const double r = parameters_.cava_radius;
  return 0.95 * elliptic_cylinder(p.x() - c.x(), p.y() - c.y(), 1.12 * r, 0.9 * r);
}

double LiverShape::gallbladder(const Vec& p) const { return smooth_min(bladder_(p), bladder_neck_(p), 12.0); }

double LiverShape::right_kidney(const Vec& p) const {
  const Vec d = p - Vec(-64.0, 54.0, -58.0);
  // The upper pole leans inwards and backwards.
  const Vec q(d.x() - 0.22 * d.z(), d.y() - 0.15 * d.z(), d.z());
  return 0.95 * ellipsoid(q, {29.0, 26.0, 55.0});
}

double LiverShape::liver(const Vec& p) const {
  // Sharp in front, where the wall meets the visceral surface; rounded at the back.
  const double edge = mix(5.0, 34.0, smooth_step(-30.0, 35.0, p.y()));
  double f = smooth_max(upper(p), visceral(p), edge);
  if (f > 60.0) return f;
  // The caudate lobe fills the corner between the porta and the vena cava.
  f = smooth_min(f, ellipsoid(p - Vec(-17.0, 21.0, 20.0 + parameters_.lift), {25.0, 17.0, 33.0}), 16.0);
  // The spine with its crura, then the grooves and impressions of the visceral and posterior sides.
  f = smooth_max(f, -elliptic_cylinder(p.x() - 9.0, p.y() - 66.0, 45.0, 44.0), 18.0);
  f = smooth_max(f, -cava(p), 3.0);
  f = smooth_max(f, -(gallbladder(p) - 0.3), 4.0);
  f = smooth_max(f, -(right_kidney(p) - 2.5), 16.0);
  f = smooth_max(f, -porta_(p), 12.0);
  return smooth_max(f, -fissure_(p), 9.0);
}

Vec LiverShape::gradient(const Vec& p) const {
  constexpr double h = 0.05;
  Vec g;
  for (int i = 0; i < 3; ++i) {
    const Vec step = h * Vec::Unit(i);
    g[i] = (liver(p + step) - liver(p - step)) / (2.0 * h);
  }
  return g;
}

std::pair<double, double> LiverShape::extent_at(double x, double y) const {
  double bottom = 1.0, top = 0.0;
  double best = 0.0, start = 0.0;
  bool within = false;
  for (double z = low().z(); z <= high().z(); z += 1.0) {
    const bool now = liver({x, y, z}) < 0.0;
    if (now && !within) start = z;
    if (now && z - start >= best) {
      best = z - start;
      bottom = start;
      top = z;
    }
    within = now;
  }
  return {bottom, top};
}

Vec LiverShape::point_inside(double x, double y, double s) const {
  const double mx = right_centre_.x() + 20.0, my = right_centre_.y() - 5.0;
  for (double pull = 0.0; pull <= 1.0; pull += 0.05) {
    const double px = mix(x, mx, pull), py = mix(y, my, pull);
    const auto [bottom, top] = extent_at(px, py);
    if (top - bottom > 24.0) return {px, py, mix(bottom, top, s)};
  }
  return {mx, my, 0.0};
}

double liver_volume_ml(const LiverShape& shape, double spacing) {
  long inside = 0;
  const Vec low = shape.low(), high = shape.high();
  for (double z = low.z(); z < high.z(); z += spacing)
    for (double y = low.y(); y < high.y(); y += spacing)
      for (double x = low.x(); x < high.x(); x += spacing)
        if (shape.liver({x, y, z}) < 0.0) ++inside;
  return static_cast<double>(inside) * spacing * spacing * spacing * 1e-3;
}

}  // namespace glisson::insilico
