// SPDX-License-Identifier: GPL-3.0-or-later
#include <numbers>

#include "liver_shape.h"

namespace glisson::insilico {

namespace {
/// The ridge is seen from here at every angle once (the organ is star-shaped in plan around it).
constexpr double kCentreX = -25.0, kCentreY = -12.0;
}  // namespace

Vec LiverShape::ridge_point(double angle, bool notched) const {
  const auto at = [&](double reach) {
    const double x = kCentreX + reach * std::cos(angle), y = kCentreY - reach * std::sin(angle);
    return Vec(x, y, visceral_height(x, y));
  };
  const auto field = [&](double reach) { return notched ? upper(at(reach)) : lobes(at(reach)); };
  double inside = 160.0;
  while (inside > 1.0 && field(inside) > 0.0) inside -= 1.0;
  double outside = inside + 1.0;
  for (int step = 0; step < 40; ++step) {
    const double middle = 0.5 * (inside + outside);
    (field(middle) > 0.0 ? outside : inside) = middle;
  }
  return at(0.5 * (inside + outside));
}

void LiverShape::place_notch() {
  const ShapeParameters& s = parameters_;
  // The angle under which the ridge passes x = notch_x, in front.
  double low = 0.2 * std::numbers::pi, high = 0.8 * std::numbers::pi;
  for (int step = 0; step < 50; ++step) {
    const double middle = 0.5 * (low + high);
    (ridge_point(middle, false).x() > s.notch_x ? low : high) = middle;
  }
  const Vec ridge = ridge_point(0.5 * (low + high), false);
  const Vec outwards = Vec(0.05, -0.80, -0.60).normalized();
  notch_ = {ridge - s.notch_depth * outwards + Vec(0, 0, 2), ridge + 12.0 * outwards, 3.5, 14.0};
  // The fissure of the round ligament runs on from the notch along the visceral surface to the porta.
  const auto below = [&](double x, double y, double depth) {
    return Vec(x, y, visceral_height(x, y) - depth);
  };
  fissure_ = {below(ridge.x(), ridge.y() + s.notch_depth, 2.0), below(mix(ridge.x(), 4.0, 0.8), -24.0, 3.5),
              5.5, 4.5};
}

void LiverShape::place_gallbladder() {
  const ShapeParameters& s = parameters_;
  // The fundus stays some way behind the margin; the neck points to the hilum.
  const Vec neck(hilum_.x() - 16.0, hilum_.y() - 6.0, 0.0);
  Vec towards(s.bladder_x - neck.x(), -0.85 * s.bladder_length, 0.0);
  towards *= s.bladder_length / towards.norm();
  Vec fundus = neck + towards;
  while (lobes({fundus.x(), fundus.y(), visceral_height(fundus.x(), fundus.y())}) > -24.0 &&
         (fundus - neck).norm() > 30.0)
    fundus -= 0.02 * towards;
  const auto hang = [&](const Vec& p, double depth) {
    return Vec(p.x(), p.y(), visceral_height(p.x(), p.y()) - depth);
  };
  bladder_ = {hang(neck + 0.35 * (fundus - neck), 5.0), hang(fundus, 7.0), 8.5, 13.5};
  bladder_neck_ = {hang(neck, 4.0), hang(neck + 0.4 * (fundus - neck), 5.0), 3.5, 8.0};
}

Vec LiverShape::on_surface(Vec p) const {
  for (int step = 0; step < 12; ++step) {
    const Vec g = gradient(p);
    if (g.squaredNorm() < 1e-6) break;
    p -= liver(p) * g / g.squaredNorm();
  }
  return p;
}

std::vector<Vec> LiverShape::anterior_margin(double spacing) const {
  std::vector<Vec> traced;
  constexpr int kRays = 1600;
  for (int i = 0; i <= kRays; ++i) {
    // From the right flank through the front to the left tip.
    const double angle = std::numbers::pi * mix(1.02, 0.03, static_cast<double>(i) / kRays);
    traced.push_back(on_surface(ridge_point(angle, true)));
  }
  std::vector<Vec> even{traced.front()};
  for (std::size_t i = 1; i < traced.size(); ++i) {
    while ((traced[i] - even.back()).norm() >= spacing) {
      const Vec step = (traced[i] - even.back()).normalized() * spacing;
      const Vec next = on_surface(even.back() + step);
      // Over an edge the surface may lead back: a step that comes no nearer would be taken for ever.
      const bool nearer = (traced[i] - next).norm() < (traced[i] - even.back()).norm();
      if ((traced[i] - even.back()).norm() < 2.0 * spacing || !nearer)
        even.push_back(traced[i]);
      else
        even.push_back(next);
    }
  }
  return even;
}

Vec LiverShape::umbilical_notch() const {
  const std::vector<Vec> margin = anterior_margin(1.0);
  Vec deepest = margin.front();
  double best = 1e9;
  for (const Vec& p : margin) {
    const double distance = (p - notch_.a).norm();
    if (distance < best) {
      best = distance;
      deepest = p;
    }
  }
  return deepest;
}

}  // namespace glisson::insilico
