// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/insilico/liver_population.h"

#include <functional>
#include <vector>

#include "glisson/core/error.h"
#include "liver_shape.h"
#include "patient_surfaces.h"
#include "tissue.h"

namespace glisson::insilico {
namespace {

constexpr double kTouchingMm = 1.0;  // how far from a neighbour's surface its bed ends
constexpr int kLinePoints = 60;

Points in_metres(const std::vector<Vec>& points) {
  Points rows(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i)
    rows.row(static_cast<Eigen::Index>(i)) = 1e-3 * points[i].transpose();
  return rows;
}

Vec on_surface(const LiverShape& shape, Vec p) {
  for (int step = 0; step < 20; ++step) {
    const Vec g = shape.gradient(p);
    if (g.squaredNorm() < 1e-6) break;
    p -= shape.liver(p) * g / g.squaredNorm();
  }
  return p;
}

Points touching(const TriangleMesh& liver, const std::function<bool(const Vec&)>& touches) {
  std::vector<Vec> chosen;
  for (int i = 0; i < liver.vertex_count(); ++i)
    if (const Vec p = 1e3 * liver.vertex(i); touches(p)) chosen.push_back(p);
  return in_metres(chosen);
}

/// From the notch over the top of the dome to the front of the cava where it leaves the liver.
std::vector<Vec> falciform(const LiverShape& shape, const Vec& notch) {
  const Vec cava = shape.cava_centre(kCavaTop);
  const Vec end(cava.x(), cava.y() - shape.parameters().cava_radius - 4.0, 0.0);
  std::vector<Vec> line{notch};
  for (int i = 1; i <= kLinePoints; ++i) {
    const double share = static_cast<double>(i) / kLinePoints;
    const double x = mix(notch.x(), end.x(), share), y = mix(notch.y(), end.y(), share);
    const auto [low, high] = shape.extent_at(x, y);
    if (low > high) continue;
    const Vec p = on_surface(shape, {x, y, high});
    if ((p - line.back()).norm() > 0.5) line.push_back(p);
  }
  return line;
}

}  // namespace

PopulationLiver population_liver(std::uint64_t shape_seed, double spacing_mm) {
  if (!(spacing_mm >= 0.5 && spacing_mm <= 20.0))
    throw InputError("population_liver", "spacing_mm", "is " + std::to_string(spacing_mm),
                     "Choose 0.5 to 20");
  const LiverShape shape(draw_shape(shape_seed));
  PopulationLiver liver;
  liver.surface =
      contour(shape.low(), shape.high(), spacing_mm, [&](const Vec& p) { return shape.liver(p); });
  const Vec notch = shape.umbilical_notch();
  liver.umbilical_notch = in_metres({notch});
  liver.anterior_margin = in_metres(shape.anterior_margin(3.0));
  liver.falciform_line = in_metres(falciform(shape, notch));
  liver.vena_cava = touching(liver.surface,
                             [&](const Vec& p) { return shape.cava(p) <= kTouchingMm && p.z() <= kCavaTop; });
  liver.portal_entrance = in_metres({on_surface(shape, shape.hilum())});
  liver.gallbladder_bed =
      touching(liver.surface, [&](const Vec& p) { return shape.gallbladder(p) <= kTouchingMm; });
  return liver;
}

}  // namespace glisson::insilico
