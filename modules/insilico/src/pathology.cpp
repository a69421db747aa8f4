// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/insilico/pathology.h"

#include <array>
#include <cmath>

#include "ct_scene.h"
#include "tissue.h"

namespace glisson::insilico {
namespace {

constexpr double kBulge = 3.0;  // mm that a lesion at the rim bulges out of the organ

/// Grey values of one phase, HU.
struct Phase {
  double liver, portal, hepatic, cava, tumour, hot;
  /// What becomes of the tissues around the liver: pairs of before and after, rising.
  std::vector<std::array<double, 2>> others;
};

Phase phase_of(const Pathology& pathology, Dice& dice) {
  const double shift = dice.between(-9.0, 9.0);
  Phase phase{
      106.0 + shift, 166.0 + shift, 158.0 + shift, 143.0 + shift, dice.between(48.0, 72.0), 150.0, {}};
  if (pathology.phase == Pathology::Phase::late_arterial)
    phase = {82.0 + shift,
             128.0,
             86.0 + shift,
             92.0,
             58.0,
             127.0 + shift,
             {{60, 60}, {100, 84}, {122, 138}, {168, 290}, {195, 225}, {300, 300}}};
  if (pathology.phase == Pathology::Phase::unenhanced)
    phase = {59.0 + 0.4 * shift,
             41.0,
             41.0,
             40.0,
             34.0,
             70.0,
             {{60, 54}, {90, 42}, {100, 44}, {122, 50}, {168, 42}, {200, 48}, {300, 290}}};
  if (pathology.fatty) phase.liver = 42.0 + 0.5 * shift, phase.tumour = 66.0;
  if (pathology.cirrhotic) phase.liver -= 8.0;
  return phase;
}

double mapped(const std::vector<std::array<double, 2>>& table, double value) {
  if (table.empty() || value <= table.front()[0] || value >= table.back()[0]) return value;
  std::size_t n = 1;
  while (table[n][0] < value) ++n;
  const auto& [x0, y0] = table[n - 1];
  const auto& [x1, y1] = table[n];
  return mix(y0, y1, (value - x0) / (x1 - x0));
}

struct PlacedLesion {
  LesionKind kind;
  Lesion body;
};

/// Where the liver's surface lies from `inside` towards `way`.
Vec surface_along(const LiverShape& shape, const Vec& inside, const Vec& way) {
  Vec p = inside;
  for (int step = 0; step < 400 && shape.liver(p) < 0.0; ++step) p += 0.5 * way;
  return p;
}

Vec centre_of(const LiverShape& shape, const LesionKind& kind, Dice& dice) {
  const double r = kind.radius_mm;
  if (kind.place == LesionKind::Place::beside_cava) {
    const double z = dice.between(34.0, 62.0);
    const Vec way = Vec(-1.0, dice.between(-0.9, 0.1), 0.0).normalized();
    return shape.cava_centre(z) + (shape.parameters().cava_radius + 0.92 * r) * way;
  }
  const double back = dice.between(-40.0, 20.0), side = dice.between(-90.0, -40.0);
  const Vec middle = shape.point_inside(side, back, 0.5);
  if (kind.place == LesionKind::Place::deep) {
    for (int attempt = 0; attempt < 300; ++attempt) {
      const Vec p = dice.inside(shape.low(), shape.high());
      if (shape.liver(p) < -r - 3.0) return p;
    }
    return middle;
  }
  const double up = dice.between(-0.5, 0.9), y = dice.between(-1.0, 0.4), x = dice.between(-1.0, 0.3);
  const Vec way = Vec(x, y, up).normalized();
  return surface_along(shape, middle, way) - 0.72 * r * way;
}

std::vector<PlacedLesion> place(const LiverShape& shape, const Pathology& pathology, Dice& dice) {
  std::vector<PlacedLesion> placed;
  for (const LesionKind& kind : pathology.lesions) {
    Lesion best{Vec::Zero(), Vec::Ones()};
    double best_room = -1e9;
    for (int attempt = 0; attempt < 40; ++attempt) {
      Lesion lesion{Vec::Zero(), Vec::Ones()};
      lesion.centre = centre_of(shape, kind, dice);
      const double a = dice.between(0.88, 1.12), b = dice.between(0.88, 1.12);
      lesion.half_axes = kind.radius_mm * Vec(a, b, 1.0 / (a * b));
      lesion.phase = dice.between(0.0, 6.0);
      double room = 1e3;
      for (const PlacedLesion& other : placed)
        room =
            std::min(room, (other.body.centre - lesion.centre).norm() - other.body.reach() - lesion.reach());
      if (room > best_room) best_room = room, best = lesion;
      if (room > 4.0) break;
    }
    placed.push_back({kind, best});
  }
  return placed;
}

double look_at(const LesionKind::Look look, const Phase& phase, const Vec& p, double f, double radius,
               std::uint64_t seed) {
  const double texture = mottle(p, 5.0, seed + 61);
  switch (look) {
    case LesionKind::Look::hypodense:
      return phase.tumour + 4.0 * texture;
    case LesionKind::Look::necrotic:
      return mix(phase.tumour + 12.0, 22.0, smooth_step(-0.25 * radius, -0.5 * radius, f)) + 5.0 * texture;
    case LesionKind::Look::calcified:
      return mix(phase.tumour, 330.0, smooth_step(0.8, 1.3, mottle(p, 7.0, seed + 62))) + 4.0 * texture;
    case LesionKind::Look::rim_enhancing:
      return mix(phase.liver + 32.0, phase.tumour - 8.0, smooth_step(-1.5, -4.5, f)) + 3.0 * texture;
    case LesionKind::Look::cyst:
      return 6.0;
    case LesionKind::Look::hyperdense:
      return phase.hot + 5.0 * texture;
  }
  return phase.tumour;
}

/// Everything of the liver, painted and labelled with one phase's grey values.
class LiverPainter {
 public:
  LiverPainter(Canvas& canvas, std::vector<Label>& labels, const LiverShape& shape,
               const Pathology& pathology, const Phase& phase)
      : canvas_(canvas),
        labels_(labels),
        shape_(shape),
        pathology_(pathology),
        phase_(phase),
        seed_(pathology.shape_seed) {}

  void parenchyma() {
    const auto liver = [&](const Vec& p) { return organ(p); };
    const auto film = [&](const Vec& p) {
      const double f = organ(p);
      if (f > 2.0 || below_diaphragm(shape_, p) > -5.0) return f + 0.5;
      return f - 1.6 * smooth_step(-0.1, 0.9, mottle(p, 13.0, seed_ + 63));
    };
    canvas_.paint(shape_.low(), shape_.high(), film, -92.0);
    const double rough = pathology_.cirrhotic ? 9.0 : 3.0, cell = pathology_.cirrhotic ? 6.0 : 17.0;
    canvas_.paint(shape_.low(), shape_.high(), liver,
                  [&](const Vec& p, double) { return phase_.liver + rough * mottle(p, cell, seed_ + 64); });
    tag(shape_.low(), shape_.high(), liver, structure::kParenchyma);
  }
  void tree(const GrownTree& tree, double hounsfield, Label label) {
    const double half_voxel = 0.5 * std::cbrt(canvas_.grid().voxel_volume_mm3());
    const std::vector<float> field = tree_field(canvas_.grid(), tree, half_voxel + 0.1, 1e3F);
    for (std::size_t at = 0; at < field.size(); ++at) {
      if (field[at] >= half_voxel) continue;
      const double share = std::min(1.0, 0.5 - 0.5 * field[at] / half_voxel);
      canvas_.voxels()[at] += static_cast<float>(share * (hounsfield - canvas_.voxels()[at]));
      if (field[at] < 0.0F) labels_[at] = label;
    }
  }
  void cava_and_gallbladder() {
    const auto cava = [&](const Vec& p) { return std::max(shape_.cava(p), p.z() - kCavaTop); };
    const Vec low(-60, -40, -1e3), high(30, 60, kCavaTop);
    canvas_.paint(low, high, cava, phase_.cava);
    tag(low, high, cava, structure::kVenaCava);
    const auto bladder = [&](const Vec& p) { return shape_.gallbladder(p); };
    canvas_.paint(shape_.low(), shape_.high(), bladder,
                  [](const Vec&, double f) { return f > -1.3 ? 75.0 : 9.0; });
    tag(shape_.low(), shape_.high(), bladder, structure::kGallbladder);
  }
  void lesion(const PlacedLesion& placed, Label label) {
    const Lesion& body = placed.body;
    const Vec reach = Vec::Constant(body.reach() + 3.0);
    const auto field = [&](const Vec& p) {
      const double own = body.field(p);
      if (own > 6.0) return own;
      return std::max({own, organ(p) - kBulge, shape_.cage(p) + 1.5, below_diaphragm(shape_, p) + 1.0,
                       -shape_.cava(p), -shape_.gallbladder(p)});
    };
    canvas_.paint(body.centre - reach, body.centre + reach, field, [&](const Vec& p, double) {
      return look_at(placed.kind.look, phase_, p, body.field(p), placed.kind.radius_mm, seed_);
    });
    tag(body.centre - reach, body.centre + reach, field, label);
  }

 private:
  double organ(const Vec& p) const {
    const double f = shape_.liver(p);
    if (!pathology_.cirrhotic || std::abs(f) > 6.0) return f;
    return f + 1.1 * mottle(p, 11.0, seed_ + 65);
  }
  template <class FieldFunction>
  void tag(const Vec& low, const Vec& high, const FieldFunction& field, Label label) {
    canvas_.where(low, high, 0.0, field, [&](std::size_t at, const Vec&, double) { labels_[at] = label; });
  }

  Canvas& canvas_;
  std::vector<Label>& labels_;
  const LiverShape& shape_;
  const Pathology& pathology_;
  const Phase& phase_;
  std::uint64_t seed_;
};

/// Bright and dark rays from a piece of metal, in the slices that it lies in (the shadows of a beam that lost
/// its soft part).
void streak(Canvas& canvas, const Vec& metal, Dice& dice) {
  const VolumeGrid& grid = canvas.grid();
  std::array<double, 5> phase{};
  for (double& p : phase) p = dice.between(0.0, 6.28);
  std::size_t at = 0;
  for (int k = 0; k < grid.size.z(); ++k)
    for (int j = 0; j < grid.size.y(); ++j)
      for (int i = 0; i < grid.size.x(); ++i, ++at) {
        const Vec d = canvas.centre(i, j, k) - metal;
        const double across = std::hypot(d.x(), d.y());
        if (std::abs(d.z()) > 7.0) continue;
        const double angle = std::atan2(d.y(), d.x());
        double ray = 0.0;
        for (std::size_t n = 0; n < phase.size(); ++n)
          ray += std::cos(static_cast<double>(3 + 4 * n) * angle + phase[n]);
        canvas.voxels()[at] += static_cast<float>(32.0 * ray * std::exp(-across / 60.0));
        if (d.norm() < 5.0) canvas.voxels()[at] = 2800.0F;
      }
}

/// A grid whose slices are thinner by a whole number, so that each thick slice is a mean.
VolumeGrid thin_grid(const Eigen::Vector3d& spacing, int& thinner) {
  thinner = std::max(1, static_cast<int>(std::ceil(spacing.z() / 2.0)));
  return ct_grid({spacing.x(), spacing.y(), spacing.z() / thinner});
}

template <class Value, class Combine>
std::vector<Value> thick(const std::vector<Value>& thin, const VolumeGrid& grid, int slices, int thinner,
                         const Combine& combine) {
  const auto plane = static_cast<std::size_t>(grid.size.x()) * static_cast<std::size_t>(grid.size.y());
  std::vector<Value> result(plane * static_cast<std::size_t>(slices));
  for (std::size_t k = 0; k < static_cast<std::size_t>(slices); ++k)
    for (std::size_t n = 0; n < plane; ++n)
      result[k * plane + n] = combine(thin.data() + k * static_cast<std::size_t>(thinner) * plane + n, plane);
  return result;
}

PathologyCt scanned(const Canvas& canvas, const std::vector<Label>& labels, const Pathology& pathology,
                    int thinner) {
  const VolumeGrid& thin = canvas.grid();
  const int slices = thin.size.z() / thinner;
  PathologyCt result;
  VolumeGrid grid = thin;
  grid.size.z() = slices;
  grid.spacing_mm.z() *= thinner;
  grid.origin_mm.z() += 0.5 * (thinner - 1) * thin.spacing_mm.z();
  // Bodies of another size: the whole patient is scaled.
  grid.spacing_mm *= pathology.body_scale;
  grid.origin_mm *= pathology.body_scale;
  result.ct.grid = grid;
  result.ct.description = "Synthetic patient, " + pathology.name;
  const double noise = pathology.noise_hu * std::sqrt(static_cast<double>(thinner));
  result.ct.voxels = std::make_shared<const std::vector<std::int16_t>>(
      thick<std::int16_t>(scan(canvas, 0.9, noise, pathology.shape_seed), thin, slices, thinner,
                          [&](const std::int16_t* first, std::size_t plane) {
                            int sum = 0;
                            for (int n = 0; n < thinner; ++n)
                              sum += first[static_cast<std::size_t>(n) * plane];
                            return static_cast<std::int16_t>(std::lround(static_cast<double>(sum) / thinner));
                          }));
  result.truth.voxels = LabelVolume(
      grid, thick<Label>(labels, thin, slices, thinner, [&](const Label* first, std::size_t plane) {
        return first[static_cast<std::size_t>(thinner / 2) * plane];
      }));
  const std::vector<long> counts = result.truth.voxels.histogram();
  for (std::size_t label = 1; label < counts.size(); ++label)
    if (counts[label] > 0) result.truth.infos.push_back(structure_info(static_cast<Label>(label)));
  return result;
}

}  // namespace

std::vector<Pathology> pathologies(std::uint64_t seed) {
  using Look = LesionKind::Look;
  using Place = LesionKind::Place;
  std::vector<Pathology> all;
  const auto add = [&](const char* name, std::vector<LesionKind> lesions) -> Pathology& {
    Pathology one;
    one.name = name;
    one.shape_seed = 100 * seed + all.size() + 11;
    one.lesions = std::move(lesions);
    all.push_back(std::move(one));
    return all.back();
  };
  add("hypodense, rim", {{Look::hypodense, Place::rim, 28.0}});
  add("hypodense, cava and rim",
      {{Look::hypodense, Place::beside_cava, 26.0}, {Look::hypodense, Place::rim, 27.0}});
  add("necrotic", {{Look::necrotic, Place::rim, 32.0}, {Look::necrotic, Place::deep, 16.0}});
  add("calcified", {{Look::calcified, Place::rim, 18.0}, {Look::calcified, Place::deep, 12.0}});
  add("rim-enhancing", {{Look::rim_enhancing, Place::deep, 14.0},
                        {Look::rim_enhancing, Place::deep, 11.0},
                        {Look::rim_enhancing, Place::rim, 12.0},
                        {Look::rim_enhancing, Place::deep, 8.0}});
  add("cysts", {{Look::cyst, Place::rim, 26.0}, {Look::cyst, Place::deep, 14.0}});
  add("fatty", {{Look::hypodense, Place::deep, 13.0}}).fatty = true;
  add("cirrhotic", {{Look::hypodense, Place::deep, 15.0}}).cirrhotic = true;
  add("late arterial", {{Look::hyperdense, Place::deep, 18.0}, {Look::hyperdense, Place::rim, 13.0}}).phase =
      Pathology::Phase::late_arterial;
  add("unenhanced", {{Look::hypodense, Place::deep, 18.0}}).phase = Pathology::Phase::unenhanced;
  add("noisy", {{Look::hypodense, Place::deep, 14.0}}).noise_hu = 32.0;
  Pathology& slices = add("slices of 5 mm", {{Look::hypodense, Place::rim, 20.0}});
  slices.spacing_mm = {0.9, 0.9, 5.0};
  add("metal", {{Look::hypodense, Place::deep, 14.0}}).metal = true;
  add("large body", {{Look::hypodense, Place::rim, 34.0}, {Look::hypodense, Place::deep, 15.0}}).body_scale =
      1.13;
  add("small body", {{Look::hypodense, Place::beside_cava, 17.0}, {Look::hyperdense, Place::deep, 10.0}})
      .body_scale = 0.87;
  return all;
}

Cancellable<PathologyCt> make_pathology_ct(const Pathology& pathology, const RunContext& context) {
  const LiverShape shape(draw_shape(pathology.shape_seed));
  Dice dice(RunContext({}, nullptr, pathology.shape_seed).random("insilico.pathology"));
  const Phase phase = phase_of(pathology, dice);
  const std::vector<PlacedLesion> placed = place(shape, pathology, dice);
  std::vector<Lesion> bodies;
  for (const PlacedLesion& lesion : placed) bodies.push_back(lesion.body);
  const auto trees = grow_trees(shape, bodies, {}, context.part(0.0, 0.2));
  if (!trees) return {};
  int thinner = 1;
  Canvas canvas(thin_grid(pathology.spacing_mm, thinner), -1000.0F);
  if (!paint_trunk(canvas, shape, context.part(0.2, 0.5))) return {};
  if (!paint_organs(canvas, shape, context.part(0.5, 0.7))) return {};
  for (float& value : canvas.voxels()) value = static_cast<float>(mapped(phase.others, value));
  std::vector<Label> labels(canvas.voxels().size(), structure::kBackground);
  LiverPainter painter(canvas, labels, shape, pathology, phase);
  painter.parenchyma();
  if (context.cancelled()) return {};
  painter.tree(trees->portal, phase.portal, structure::kPortalVein);
  painter.tree(trees->hepatic, phase.hepatic, structure::kHepaticVeins);
  painter.cava_and_gallbladder();
  for (std::size_t n = 0; n < placed.size(); ++n)
    painter.lesion(placed[n], static_cast<Label>(structure::kFirstLesion + n));
  if (pathology.metal) streak(canvas, shape.hilum() + Vec(-20.0, 6.0, 14.0), dice);
  if (context.cancelled()) return {};
  context.progress(0.85, "patient.scan");
  return scanned(canvas, labels, pathology, thinner);
}

}  // namespace glisson::insilico
