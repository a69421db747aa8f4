// SPDX-License-Identifier: GPL-3.0-or-later
#include <numbers>

#include "ct_scene.h"
#include "tissue.h"

namespace glisson::insilico {

double below_diaphragm(const LiverShape& shape, const Vec& p) {
  const Vec left(p.x() - 66.0, p.y() - 8.0, soft_ramp(p.z() + 6.0, 10.0));
  const double left_dome = ellipsoid(left, {76.0, 90.0, 80.0});
  // The costophrenic recess: lungs reach lowest at the back.
  const double recess = 0.9 * (p.z() - mix(8.0, -34.0, smooth_step(-70, 90, p.y())));
  // The crura stand before the spine up to the hiatus.
  const double crura = std::max(elliptic_cylinder(p.x() - 4.0, p.y() - 40.0, 46.0, 36.0), p.z() - 42.0);
  return smooth_min(smooth_min(smooth_min(shape.dome(p), left_dome, 12.0), recess, 10.0), crura, 10.0) - 2.6;
}

namespace {

double skin(const Vec& p) {
  // More fat in front and at the flanks further down.
  const double belly = smooth_step(40.0, -120.0, p.z());
  const double body = trunk_ring(p, 2.0 - 2.0 * belly, 161.0 + 6.0 * belly, 117.0 + 7.0 * belly);
  // A furrow over the spine.
  return smooth_max(body, -elliptic_cylinder(p.x(), p.y() - 133.0, 26.0, 16.0), 16.0);
}

double muscle_wall(const Vec& p) { return trunk_ring(p, 1.0, 150.0, 107.0); }

/// The surface on which the ribs lie.
double rib_wall(const Vec& p) { return trunk_ring(p, 1.0, 144.5, 102.0); }

/// Round the trunk from the spine (0) to the sternum (180 degrees), alike on both sides.
double turn_degrees(const Vec& p) {
  return std::atan2(std::abs(p.x()) / 144.5, p.y() / 102.0) * 180.0 / std::numbers::pi;
}

/// Bone of one vertebra or disc, seen as distances within the plane.
void paint_spine(Canvas& canvas) {
  const auto lordosis = [](double z) { return 54.0 + 5.0 * std::sin((z + 60.0) / 90.0); };
  constexpr double kPitch = 33.0;
  const auto body = [&](const Vec& p) {
    const double waist = 1.2 * std::cos(2.0 * std::numbers::pi * p.z() / kPitch);
    return elliptic_cylinder(p.x(), p.y() - lordosis(p.z()), 22.5 + waist, 17.0 + waist);
  };
  const auto in_disc = [&](double z) { return std::abs(z / kPitch - std::round(z / kPitch)) * kPitch < 4.0; };
  const Vec low(-60, 20, -1e3), high(60, 125, 1e3);
  const auto arch = [&](const Vec& p) {
    const double y = p.y() - lordosis(p.z());
    const double rise = std::abs((p.z() - 10.0) / kPitch - std::round((p.z() - 10.0) / kPitch)) * kPitch;
    const double canal = elliptic_cylinder(p.x(), y - 26.0, 15.0, 12.5);
    const double spinous = std::max({std::abs(p.x()) - 3.6, y - 60.0, 30.0 - y, rise - 11.0});
    const double transverse =
        std::max({std::abs(p.x()) - 36.0, std::abs(y - 27.0 - 0.15 * std::abs(p.x())) - 4.0, rise - 6.0});
    return 0.8 * std::min({std::max(canal, rise - 14.0), spinous, transverse});
  };
  canvas.paint(low, high, arch,
               [](const Vec&, double f) { return mix(tissue::kMarrow, 420.0, smooth_step(-4, -1, f)); });
  canvas.paint(low, high, body, [&](const Vec& p, double f) {
    if (in_disc(p.z())) return tissue::kDisc;
    const double edge = std::max(f, std::abs(p.z() / kPitch - std::round(p.z() / kPitch)) * -kPitch + 4.0);
    return mix(tissue::kMarrow, tissue::kCortical, smooth_step(-1.8, -0.5, edge)) + 18.0 * mottle(p, 4.0, 11);
  });
  canvas.paint(
      low, high,
      [&](const Vec& p) { return elliptic_cylinder(p.x(), p.y() - lordosis(p.z()) - 26.5, 9.5, 8.0); },
      tissue::kCanal);
}

/// Ribs 4 to 12: tubes in the wall that fall from the spine to the flank and, as cartilage, rise to the
/// sternum.
void paint_ribs(Canvas& canvas) {
  struct Rib {
    double height, end;  ///< z at the spine; angle of the free or cartilage end, degrees from the spine
  };
  const Rib ribs[] = {{-22, 62},  {2, 88},    {27, 118},  {52, 132}, {78, 138},
                      {104, 140}, {130, 142}, {156, 144}, {182, 146}};
  const auto rib = [&](const Vec& p) {
    const double wall = rib_wall(p);
    if (std::abs(wall) > 12.0) return std::abs(wall) - 6.0;
    const double angle = turn_degrees(p);
    double nearest = 1e3;
    for (const Rib& r : ribs) {
      const double fall = 74.0 * smooth_step(10, r.end, angle) * (r.end / 140.0);
      double across = 0.78 * (p.z() - (r.height - fall));
      const double beyond = std::max({0.0, (angle - r.end) * 2.2, (14.0 - angle) * 2.0});
      across = length(across, beyond);
      nearest = std::min(nearest, length(across / 7.0, wall / 4.4));
    }
    return 4.4 * (nearest - 1.0);
  };
  const auto cartilage = [&](const Vec& p) {
    const double wall = rib_wall(p);
    if (std::abs(wall) > 12.0 || p.y() > 0.0) return std::abs(wall) + 1.0;
    const double angle = turn_degrees(p);
    double nearest = 1e3;
    for (const Rib& r : ribs) {
      if (r.end < 130.0) continue;
      const double way = std::clamp((angle - r.end) / (172.0 - r.end), 0.0, 1.0);
      const double start = r.height - 74.0 * (r.end / 140.0);
      const double across = 0.7 * (p.z() - (start + way * way * std::max(0.0, 66.0 - 0.5 * start)));
      const double beyond = std::max({0.0, (r.end - angle) * 2.0, (angle - 172.0) * 2.0});
      nearest = std::min(nearest, length(length(across, beyond) / 6.5, wall / 4.2));
    }
    return 4.2 * (nearest - 1.0);
  };
  const Vec low(-160, -120, -1e3), high(160, 120, 1e3);
  canvas.paint(low, high, cartilage, tissue::kCartilage);
  canvas.paint(low, high, rib,
               [](const Vec&, double f) { return mix(150.0, 520.0, smooth_step(-3.2, -1.2, f)); });
  const auto sternum = [](const Vec& p) {
    return std::max(elliptic_cylinder(p.x(), p.y() + 101.0 * trunk_scale(p.z()), 17.0, 6.0),
                    0.8 * (46.0 - p.z()));
  };
  canvas.paint(low, high, sternum,
               [](const Vec&, double f) { return mix(140.0, 400.0, smooth_step(-3.5, -1.0, f)); });
}

/// Psoas before the spine's flanks, from the twelfth rib downwards; the erectors behind, thinner behind the
/// lungs.
void paint_back_muscles(Canvas& canvas, std::uint64_t seed) {
  for (const double side : {-1.0, 1.0}) {
    const auto psoas = [side](const Vec& p) {
      const double full = smooth_step(20.0, -70.0, p.z());
      const double out = 28.0 + 14.0 * smooth_step(-20.0, -150.0, p.z());
      return elliptic_cylinder(p.x() - side * out, p.y() - 58.0, 4.0 + 12.0 * full, 6.0 + 12.0 * full) +
             10.0 * smooth_step(8.0, 22.0, p.z());
    };
    canvas.paint({-70, 20, -1e3}, {70, 95, 30}, psoas, tissue::kMuscle);
    const auto erector = [side](const Vec& p) {
      const double chest = smooth_step(-20.0, 50.0, p.z());
      return elliptic_cylinder(p.x() - side * 31.0, p.y() - mix(92.0, 98.0, chest) * trunk_scale(p.z()), 30.0,
                               mix(19.0, 12.0, chest));
    };
    canvas.paint({-80, 60, -1e3}, {80, 130, 1e3}, erector, [&](const Vec& p, double) {
      return tissue::kMuscle - 4.0 + 9.0 * mottle(p, 5.0, seed + 5);
    });
  }
}

}  // namespace

bool paint_trunk(Canvas& canvas, const LiverShape& shape, const RunContext& context) {
  const Vec low = Vec::Constant(-1e3), high = Vec::Constant(1e3);
  const std::uint64_t seed = shape.parameters().seed;
  // The couch, then the trunk from outside in.
  canvas.paint(
      low, high, [](const Vec& p) { return std::abs(p.y() - 139.0 + 0.0011 * p.x() * p.x()) - 3.5; }, -780.0);
  canvas.paint(low, high, skin, [&](const Vec& p, double f) {
    return f > -2.0 ? tissue::kSkin : tissue::kFat + 5.0 * mottle(p, 9.0, seed + 2);
  });
  canvas.paint(low, high, muscle_wall, [&](const Vec& p, double f) {
    // Sheets of fat between the three muscles of the flank, and in the midline.
    const double sheet = std::abs(std::fmod(f + 24.0, 4.4) - 2.2) < 0.45 && p.z() < 0.0 ? 45.0 : 0.0;
    return tissue::kMuscle - sheet + 6.0 * mottle(p, 6.0, seed + 3);
  });
  if (context.cancelled()) return false;
  const auto cavity = [&](const Vec& p) { return shape.cage(p); };
  canvas.paint(low, high, cavity,
               [&](const Vec& p, double) { return tissue::kInnerFat + 6.0 * mottle(p, 8.0, seed + 4); });
  context.progress(0.3, "patient.ct");
  // Lungs over the diaphragm. The diaphragm itself is the layer left between them and what lies below.
  canvas.paint(
      low, high,
      [&](const Vec& p) {
        const double abdomen = below_diaphragm(shape, p);
        return smooth_max(std::max(shape.cage(p) + 2.0, 0.3 - abdomen),
                          -elliptic_cylinder(p.x() - 3.0, p.y() - 52.0, 29.0, 26.0), 8.0);
      },
      [&](const Vec& p, double) {
        const double vessel = mottle(p, 7.0, seed + 6) + 0.7 * mottle(p, 3.5, seed + 7);
        return tissue::kLung + 25.0 * mottle(p, 20.0, seed + 8) + 520.0 * smooth_step(1.9, 2.6, vessel);
      });
  if (context.cancelled()) return false;
  canvas.paint(
      low, high,
      [&](const Vec& p) { return std::max(shape.cage(p), std::abs(below_diaphragm(shape, p) + 1.2) - 1.6); },
      tissue::kMuscle);
  context.progress(0.7, "patient.ct");
  paint_back_muscles(canvas, seed);
  canvas.paint_bone(true);
  paint_ribs(canvas);
  paint_spine(canvas);
  canvas.paint_bone(false);
  context.progress(1.0, "patient.ct");
  return !context.cancelled();
}

}  // namespace glisson::insilico
