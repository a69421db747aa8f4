// SPDX-License-Identifier: GPL-3.0-or-later
#include "ct_scene.h"
#include "glisson/patient/label_map.h"
#include "tissue.h"

namespace glisson::insilico {

std::vector<float> tree_field(const VolumeGrid& grid, const GrownTree& tree, double reach, float far) {
  std::vector<float> field(static_cast<std::size_t>(grid.voxel_count()), far);
  for (std::size_t n = 1; n < tree.nodes.size(); ++n) {
    const auto parent = static_cast<std::size_t>(tree.parents[n]);
    const RoundCone cone{tree.nodes[parent], tree.nodes[n], tree.radii[parent], tree.radii[n]};
    const double around = std::max(cone.ra, cone.rb) + reach;
    Eigen::Vector3i first, last;
    for (int a = 0; a < 3; ++a) {
      const double low = std::min(cone.a[a], cone.b[a]) - around,
                   high = std::max(cone.a[a], cone.b[a]) + around;
      first[a] = std::max(0, static_cast<int>(std::ceil((low - grid.origin_mm[a]) / grid.spacing_mm[a])));
      last[a] = std::min(grid.size[a] - 1,
                         static_cast<int>(std::floor((high - grid.origin_mm[a]) / grid.spacing_mm[a])));
    }
    for (int k = first.z(); k <= last.z(); ++k)
      for (int j = first.y(); j <= last.y(); ++j)
        for (int i = first.x(); i <= last.x(); ++i) {
          float& value = field[static_cast<std::size_t>(grid.offset({i, j, k}))];
          const Vec p = grid.origin_mm + Vec(i, j, k).cwiseProduct(grid.spacing_mm);
          value = std::min(value, static_cast<float>(cone(p)));
        }
  }
  return field;
}

namespace {

void paint_tree(Canvas& canvas, const GrownTree& tree, double hounsfield, Label label,
                std::vector<Label>& labels) {
  const double half_voxel = 0.5 * std::cbrt(canvas.grid().voxel_volume_mm3());
  const std::vector<float> field = tree_field(canvas.grid(), tree, half_voxel + 0.1, 1e3F);
  for (std::size_t at = 0; at < field.size(); ++at) {
    if (field[at] >= half_voxel) continue;
    const double share = std::min(1.0, 0.5 - 0.5 * field[at] / half_voxel);
    canvas.voxels()[at] += static_cast<float>(share * (canvas.shown(hounsfield) - canvas.voxels()[at]));
    if (field[at] < 0.0F) labels[at] = label;
  }
}

}  // namespace

bool paint_liver(Canvas& canvas, const Anatomy& anatomy, std::vector<Label>& labels,
                 const RunContext& context) {
  const LiverShape& shape = anatomy.shape;
  const std::uint64_t seed = shape.parameters().seed;
  labels.assign(canvas.voxels().size(), structure::kBackground);
  const auto tag = [&](const Vec& low, const Vec& high, const auto& field, Label label) {
    canvas.where(low, high, 0.0, field, [&](std::size_t at, const Vec&, double) { labels[at] = label; });
  };
  const auto liver = [&](const Vec& p) { return shape.liver(p); };
  // Below the diaphragm a film of fat parts the liver from its neighbours, in patches: elsewhere they touch.
  const auto film = [&](const Vec& p) {
    const double f = shape.liver(p);
    if (f > 2.0 || below_diaphragm(shape, p) > -5.0) return f + 0.5;
    return f - 1.3 * smooth_step(-0.2, 0.8, mottle(p, 16.0, seed + 9));
  };
  canvas.paint(shape.low(), shape.high(), film, tissue::kInnerFat);
  canvas.paint(shape.low(), shape.high(), liver,
               [&](const Vec& p, double) { return tissue::kLiver + 2.5 * mottle(p, 14.0, seed); });
  tag(shape.low(), shape.high(), liver, structure::kParenchyma);
  if (context.cancelled()) return false;

  const Vec far(1e3, 1e3, 1e3);
  const auto cava = [&](const Vec& p) { return std::max(shape.cava(p), p.z() - kCavaTop); };
  const Vec cava_low(-60, -40, -1e3), cava_high(30, 60, kCavaTop);
  canvas.paint(cava_low, cava_high, cava, tissue::kCava);
  const auto bladder = [&](const Vec& p) { return shape.gallbladder(p); };
  canvas.paint(shape.low(), shape.high(), bladder,
               [](const Vec&, double f) { return f > -1.2 ? tissue::kBowelWall : tissue::kBile; });
  tag(shape.low(), shape.high(), bladder, structure::kGallbladder);
  // The hepatic veins' common stump ends in the cava, which therefore comes after them.
  paint_tree(canvas, anatomy.trees.portal, tissue::kPortal, structure::kPortalVein, labels);
  paint_tree(canvas, anatomy.trees.hepatic, tissue::kHepatic, structure::kHepaticVeins, labels);
  tag(cava_low, cava_high, cava, structure::kVenaCava);
  for (std::size_t i = 0; i < anatomy.lesions.size(); ++i) {
    const Lesion& lesion = anatomy.lesions[i];
    const Vec reach = Vec::Constant(lesion.reach() + 3.0);
    const auto field = [&](const Vec& p) { return lesion.field(p); };
    canvas.paint(lesion.centre - reach, lesion.centre + reach, field,
                 [&](const Vec& p, double) { return tissue::kTumour + 3.0 * mottle(p, 5.0, seed + 1); });
    tag(lesion.centre - reach, lesion.centre + reach, field, static_cast<Label>(structure::kFirstLesion + i));
  }
  return !context.cancelled();
}

}  // namespace glisson::insilico
