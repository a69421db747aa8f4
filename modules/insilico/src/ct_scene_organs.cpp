// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <numbers>

#include "ct_scene.h"
#include "tissue.h"

namespace glisson::insilico {

namespace {

/// A hose through points, each with its radius, smoothly joined.
struct Hose {
  std::vector<Vec> points;
  std::vector<double> radii;

  double operator()(const Vec& p) const {
    double f = 1e3;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      f = smooth_min(f, RoundCone{points[i], points[i + 1], radii[i], radii[i + 1]}(p), 8.0);
    return f;
  }
  Vec low() const { return bound(-1.0); }
  Vec high() const { return bound(1.0); }

 private:
  Vec bound(double side) const {
    Vec b = Vec::Constant(-side * 1e9);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec p = points[i] + Vec::Constant(side * (radii[i] + 6.0));
      b = side < 0.0 ? Vec(b.cwiseMin(p)) : Vec(b.cwiseMax(p));
    }
    return b;
  }
};

void paint_kidney(Canvas& canvas, const LiverShape& shape, double side) {
  const auto kidney = [&, side](const Vec& p) {
    // The left one is the right one mirrored and a vertebra's half higher.
    if (side < 0.0) return shape.right_kidney(p);
    return shape.right_kidney({-p.x() - 2.0, p.y(), p.z() - 18.0});
  };
  const Vec centre = side < 0.0 ? Vec(-64, 54, -58) : Vec(62, 54, -40);
  const auto sinus = [&](const Vec& p) {
    const Vec d = p - centre - Vec(-side * 17.0, -4.0, 0);
    return ellipsoid(d, {18.0, 8.0, 25.0}) + 2.0 * std::sin(0.42 * p.z()) + 1.2 * std::sin(0.5 * p.x());
  };
  canvas.paint(centre - Vec(50, 45, 70), centre + Vec(50, 45, 70), kidney, [&](const Vec& p, double f) {
    const double wave = 1.6 * std::sin(0.33 * p.z()) * std::cos(0.25 * p.y());
    const double cortex = mix(tissue::kMedulla, tissue::kCortex, smooth_step(-9.0, -6.0, f + wave));
    return mix(cortex, tissue::kPelvis, smooth_step(1.0, -2.0, sinus(p)));
  });
}

void paint_heart(Canvas& canvas, const LiverShape& shape) {
  // The heart lies on the diaphragm: flat below, with hardly a layer between it and the liver's domes.
  const auto heart = [&](const Vec& p) {
    const Vec d = p - Vec(22.0, -36.0, 112.0);
    const Vec q(0.92 * d.x() + 0.30 * d.z(), d.y(), 0.95 * d.z() - 0.30 * d.x());
    return smooth_max(0.95 * ellipsoid(q, {72.0, 52.0, 60.0}), -1.2 - below_diaphragm(shape, p), 5.0);
  };
  const auto sac = [&](const Vec& p) {
    return std::max({heart(p) - 5.0, shape.cage(p) + 3.0, 0.2 - below_diaphragm(shape, p)});
  };
  const Vec low(-100, -110, 20), high(130, 50, 1e3);
  canvas.paint(low, high, sac, tissue::kInnerFat);
  const Vec left_chamber(46, -38, 118), right_chamber(-4, -46, 112);
  canvas.paint(
      low, high, [&](const Vec& p) { return std::max(heart(p), shape.cage(p) + 4.0); },
      [&](const Vec& p, double) {
        // Blood and muscle differ little in this phase.
        const double left = ellipsoid(p - left_chamber, {24.0, 22.0, 30.0});
        const double right = ellipsoid(p - right_chamber, {26.0, 22.0, 32.0});
        return tissue::kHeart + 14.0 * smooth_step(2.0, -2.0, std::min(left, right));
      });
}

void paint_great_vessels(Canvas& canvas, const LiverShape& shape) {
  const auto aorta = [](const Vec& p) {
    const double x = 11.0 + 6.0 * smooth_step(20, 140, p.z()), y = 27.0 + 12.0 * smooth_step(-40, 120, p.z());
    return 0.97 * elliptic_cylinder(p.x() - x, p.y() - y, 10.0, 10.0);
  };
  canvas.paint(
      {-20, 0, -1e3}, {45, 70, 1e3}, [&](const Vec& p) { return aorta(p) - 1.0; },
      [&](const Vec& p, double) { return aorta(p) > -0.6 ? 70.0 : tissue::kAorta; });
  const Hose mesenteric{{{9, 15, -22}, {6, 4, -44}, {2, -6, -140}, {0, -8, -190}}, {4.0, 4.0, 4.0, 3.5}};
  canvas.paint(mesenteric.low(), mesenteric.high(), mesenteric, tissue::kAorta);
  const Vec portal = shape.hilum() + Vec(20.0, 4.0, -44.0);
  const Hose superior{{portal, portal + Vec(-2, 2, -30), {-8, -8, -140}, {-10, -10, -190}},
                      {5.8, 5.5, 4.6, 4.0}};
  canvas.paint(superior.low(), superior.high(), superior, tissue::kPortal);
  // The gullet comes down before the aorta and turns into the stomach.
  const Hose gullet{{{6, 20, 200}, {6, 17, 110}, {14, 10, 74}, {44, 6, 54}}, {8.0, 8.0, 8.0, 9.0}};
  canvas.paint(gullet.low(), gullet.high(), gullet,
               [](const Vec&, double f) { return mix(70.0, 20.0, smooth_step(-4.0, -5.5, f)); });
  const Hose splenic{{portal, portal + Vec(28, 8, 14), {70, 24, 4}, {96, 34, 20}}, {4.2, 4.0, 3.6, 3.0}};
  canvas.paint(splenic.low(), splenic.high(), splenic, tissue::kPortal);
}

void paint_bowel(Canvas& canvas, const LiverShape& shape, Dice& dice) {
  const auto inside = [&](const Vec& p, double f) { return std::max(f, shape.cage(p) + 3.0); };
  // Small bowel: coils below the stomach.
  for (int coil = 0; coil < 26; ++coil) {
    const Vec at = dice.inside({-85, -78, -150}, {95, 18, -62});
    const double turn = dice.between(0.0, 2.0 * std::numbers::pi), length = dice.between(14, 30);
    const Vec along(length * std::cos(turn), 0.5 * length * std::sin(turn), dice.between(-8, 8));
    const double r = dice.between(9.5, 13.0);
    const double content = dice.between(0.0, 1.0) < 0.7 ? tissue::kBowelContent : dice.between(20, 70);
    const Hose hose{{at - along, at, at + along + Vec(0, 6, 0)}, {r, r, r}};
    canvas.paint(
        hose.low(), hose.high(), [&](const Vec& p) { return inside(p, hose(p)); },
        [&](const Vec&, double f) { return f > -2.2 ? tissue::kBowelWall : content; });
  }
  // Colon: up the right flank, under the liver, across, down the left one. Stool with gas in it.
  const Hose right{{{-112, 32, -190}, {-110, 26, -130}, {-102, 8, -98}}, {19, 19, 18}};
  const Hose across{{{-98, -30, -92}, {-60, -66, -96}, {0, -74, -92}, {62, -70, -70}, {104, -30, -26}},
                    {16, 16, 15, 15, 15}};
  const Hose left{{{104, -30, -26}, {116, 22, -30}, {118, 34, -100}, {114, 30, -190}}, {15, 14, 13, 13}};
  int part = 0;
  for (const Hose* hose : {&right, &across, &left}) {
    ++part;
    canvas.paint(
        hose->low(), hose->high(),
        [&](const Vec& p) { return inside(p, (*hose)(p) + 1.2 * std::sin(0.24 * (p.x() + p.z()))); },
        [&](const Vec& p, double f) {
          if (f > -2.0) return tissue::kBowelWall - 15.0;
          const double gas = mottle(p, 11.0, 900U + static_cast<unsigned>(part)) - 0.02 * (p.y() + 40.0);
          return mix(55.0 + 30.0 * mottle(p, 4.0, 77), -880.0, smooth_step(0.5, 0.9, gas));
        });
  }
}

void paint_stomach(Canvas& canvas, const LiverShape& shape) {
  const Hose lumen{
      {{62, 22, 56}, {70, -4, 40}, {66, -36, 4}, {46, -58, -34}, {10, -58, -48}, {-16, -44, -44}},
      {34, 34, 31, 24, 17, 10}};
  const auto stomach = [&](const Vec& p) {
    return std::max({lumen(p), shape.cage(p) + 2.0, below_diaphragm(shape, p) + 1.2});
  };
  canvas.paint(lumen.low(), lumen.high(), stomach, [&](const Vec& p, double f) {
    if (f > -4.0) return tissue::kStomach + 1.0;
    // Gas gathers in front, over diluted contrast with food in it.
    const double level = -60.0 - p.y();
    const double content = tissue::kStomach + 2.0 * mottle(p, 8.0, 31);
    return mix(content, -940.0, smooth_step(-0.8, 0.8, level));
  });
  const Hose duodenum{
      {{-16, -44, -44}, {-36, -22, -44}, {-38, 4, -62}, {-34, 8, -92}, {-8, 12, -104}, {28, 12, -98}},
      {11, 13, 13, 12, 11, 11}};
  canvas.paint(duodenum.low(), duodenum.high(), duodenum, [&](const Vec&, double f) {
    return f > -2.4 ? tissue::kBowelWall + 4.0 : tissue::kBowelContent;
  });
  const Hose pancreas{
      {{-22, -6, -72}, {-12, -10, -54}, {8, -14, -38}, {38, 6, -26}, {72, 24, -2}, {90, 32, 14}},
      {14, 13, 10, 10, 10, 8}};
  canvas.paint(
      pancreas.low(), pancreas.high(),
      [&](const Vec& p) {
        return pancreas(p) + 0.9 * std::sin(0.7 * p.x()) * std::sin(0.6 * p.z() + 0.5 * p.y());
      },
      tissue::kPancreas);
}

void paint_spleen(Canvas& canvas, const LiverShape& shape) {
  const auto spleen = [&](const Vec& p) {
    const Vec d = p - Vec(98.0, 36.0, 30.0);
    const Vec q(d.x() + 0.25 * d.z(), 0.92 * d.y() - 0.38 * d.z(), 0.92 * d.z() + 0.38 * d.y());
    const double whole = 0.9 * ellipsoid(q, {33.0, 56.0, 46.0});
    const double hollow = ellipsoid(p - Vec(62, 20, 30), {20.0, 32.0, 40.0});
    return std::max({smooth_max(whole, -hollow, 8.0), shape.cage(p) + 2.0, below_diaphragm(shape, p) + 1.5});
  };
  canvas.paint({40, -40, -60}, {150, 110, 110}, spleen,
               [](const Vec& p, double) { return tissue::kSpleen + 2.0 * mottle(p, 9.0, 41); });
}

}  // namespace

bool paint_organs(Canvas& canvas, const LiverShape& shape, const RunContext& context) {
  Dice dice(RunContext({}, nullptr, shape.parameters().seed).random("insilico.bowel"));
  paint_bowel(canvas, shape, dice);
  if (context.cancelled()) return false;
  context.progress(0.3, "patient.ct");
  paint_kidney(canvas, shape, -1.0);
  paint_kidney(canvas, shape, 1.0);
  if (context.cancelled()) return false;
  context.progress(0.6, "patient.ct");
  paint_spleen(canvas, shape);
  paint_stomach(canvas, shape);
  paint_great_vessels(canvas, shape);
  if (context.cancelled()) return false;
  paint_heart(canvas, shape);
  context.progress(1.0, "patient.ct");
  return !context.cancelled();
}

}  // namespace glisson::insilico
