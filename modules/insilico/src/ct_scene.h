// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "glisson/core/run_context.h"
#include "glisson/patient/label_map.h"
#include "glisson/volume/grid.h"
#include "glisson/volume/label_volume.h"
#include "liver_shape.h"
#include "vessel_growth.h"

namespace glisson::insilico {

/// Everything that the CT shows of the liver and whose truth is known. LPS millimetres.
struct Anatomy {
  LiverShape shape;
  std::vector<Lesion> lesions;
  GrownTrees trees;
};

/// One patient of the population. The same seed gives the same anatomy.
Cancellable<Anatomy> draw_anatomy(std::uint64_t shape_seed, const RunContext& context);

/// Of the labels that paint_liver() gives.
std::vector<LabelInfo> label_infos(std::size_t lesions);

/// What another scanner than a CT shows of a tissue, which is named by its Hounsfield units (see tissue.h).
/// Bones have a table of their own: they share numbers with enhanced soft tissue.
using SignalOf = std::function<double(double hounsfield, bool bone)>;

/// A slab of a volume in Hounsfield units that fields are painted on, one over the other. A voxel that a
/// surface cuts takes its share of both sides.
class Canvas {
 public:
  Canvas(const VolumeGrid& grid, float hounsfield);
  /// Painted in signals instead, so that the shares of a voxel mix as they do in that scanner.
  Canvas(const VolumeGrid& grid, float hounsfield, SignalOf signal);

  /// What is painted from now on is bone, or is not.
  void paint_bone(bool bone) { bone_ = bone; }
  /// What the scanner shows of a tissue.
  double shown(double hounsfield) const { return signal_ ? signal_(hounsfield, bone_) : hounsfield; }

  const VolumeGrid& grid() const { return grid_; }
  std::vector<float>& voxels() { return voxels_; }
  const std::vector<float>& voxels() const { return voxels_; }

  Vec centre(int i, int j, int k) const {
    return grid_.origin_mm + Vec(i, j, k).cwiseProduct(grid_.spacing_mm);
  }

  /// Calls visit(offset, point, field value) for every voxel of the box with field < margin. Blocks that the
  /// field's slope keeps away are skipped after one evaluation.
  template <class Field, class Visit>
  void where(const Vec& low, const Vec& high, double margin, const Field& field, const Visit& visit) const {
    Eigen::Vector3i first, last;
    for (int a = 0; a < 3; ++a) {
      first[a] =
          std::max(0, static_cast<int>(std::floor((low[a] - grid_.origin_mm[a]) / grid_.spacing_mm[a])));
      last[a] = std::min(grid_.size[a] - 1,
                         static_cast<int>(std::ceil((high[a] - grid_.origin_mm[a]) / grid_.spacing_mm[a])));
    }
    const double half = 0.5 * (kBlock - 1) * grid_.spacing_mm.norm();
    for (int bk = first.z(); bk <= last.z(); bk += kBlock)
      for (int bj = first.y(); bj <= last.y(); bj += kBlock)
        for (int bi = first.x(); bi <= last.x(); bi += kBlock) {
          const Vec middle = centre(bi, bj, bk) + 0.5 * (kBlock - 1) * grid_.spacing_mm;
          if (field(middle) > margin + kSteepest * half) continue;
          for (int k = bk; k < std::min(bk + kBlock, last.z() + 1); ++k)
            for (int j = bj; j < std::min(bj + kBlock, last.y() + 1); ++j)
              for (int i = bi; i < std::min(bi + kBlock, last.x() + 1); ++i) {
                const Vec p = centre(i, j, k);
                const double f = field(p);
                if (f < margin) visit(static_cast<std::size_t>(grid_.offset({i, j, k})), p, f);
              }
        }
  }

  /// Paints {field < 0}; `hounsfield` is a number or a function of the point and the field's value.
  template <class Field, class Value>
  void paint(const Vec& low, const Vec& high, const Field& field, const Value& hounsfield) {
    const double half_voxel = 0.5 * std::cbrt(grid_.voxel_volume_mm3());
    where(low, high, half_voxel, field, [&](std::size_t at, const Vec& p, double f) {
      const double share = std::min(1.0, 0.5 - 0.5 * f / half_voxel);
      double value = 0.0;
      if constexpr (std::is_invocable_v<Value, const Vec&, double>)
        value = hounsfield(p, f);
      else
        value = hounsfield;
      voxels_[at] += static_cast<float>(share * (shown(value) - voxels_[at]));
    });
  }

 private:
  static constexpr int kBlock = 6;
  VolumeGrid grid_;
  SignalOf signal_;
  bool bone_ = false;
  std::vector<float> voxels_;
};

/// The CT's grid: the trunk from the lower kidneys to the heart.
VolumeGrid ct_grid(const Eigen::Vector3d& spacing_mm);

/// Distance of every voxel's centre to the wall of a tree (negative inside), up to `reach`; `far` beyond.
std::vector<float> tree_field(const VolumeGrid& grid, const GrownTree& tree, double reach, float far);

/// Paints the trunk around the liver: skin, fat, muscle, lungs above the diaphragm, ribs and spine.
/// @return false when cancelled, like the other painters.
bool paint_trunk(Canvas& canvas, const LiverShape& shape, const RunContext& context);

/// Paints heart, aorta, spleen, kidneys, stomach, pancreas and bowel. What lies against the liver runs on
/// under it, so that no seam of fat parts the two once the liver is painted.
bool paint_organs(Canvas& canvas, const LiverShape& shape, const RunContext& context);

/// The abdominal cavity below the diaphragm (negative inside); the diaphragm is its outermost layer.
double below_diaphragm(const LiverShape& shape, const Vec& p);

/// Paints the liver with its vessels and lesions, the vena cava and the gallbladder, and labels them.
/// @param labels receives one label a voxel.
bool paint_liver(Canvas& canvas, const Anatomy& anatomy, std::vector<Label>& labels,
                 const RunContext& context);

/// The scanner: point spread (Gaussian, sigma in mm) and correlated noise of the given standard deviation,
/// rounded to whole Hounsfield units.
std::vector<std::int16_t> scan(const Canvas& canvas, double blur_mm, double noise_hu, std::uint64_t seed);

}  // namespace glisson::insilico
