// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/insilico/layperson.h"

#include <algorithm>
#include <cmath>

#include "glisson/core/error.h"
#include "glisson/segmentation/lesion_size.h"
#include "glisson/volume/morphology.h"
#include "operator_hand.h"

namespace glisson::insilico {
namespace {

constexpr double kDeep = 8.0;                       // mm from the liver's border that an eye keeps
constexpr double kNearest = 8.0, kFarthest = 40.0;  // mm beside the liver
constexpr double kSlip = 0.05;                      // of a drawn line's length
constexpr double kInsideApart = 30.0, kOutsideApart = 25.0;
constexpr double kSoftLow = -20.0, kSoftHigh = 260.0;  // HU of what looks like an organ
constexpr double kAround = 4.0;                        // mm around the click that must look so, too

using Voxels = std::vector<Eigen::Vector3i>;

class Eye {
 public:
  Eye(const Image& ct, const LabelMap& truth, std::uint64_t seed)
      : ct_(ct), grid_(ct.grid), hand_(seed), liver_(grid_.size, grid_.spacing_mm) {
    liver_.voxels = inside_liver(truth);
    if (liver_.count() == 0)
      throw InputError("label map", "liver", "no voxel is liver", "give the labels of a liver");
  }

  Points inside(int count) {
    const std::vector<float> depth2 = squared_depth_mm2(liver_);
    return draw(where([&](std::size_t at, const Eigen::Vector3i&) { return depth2[at] > kDeep * kDeep; }),
                count, kInsideApart);
  }

  Points outside(int count) {
    const std::vector<float> away2 = squared_distance_mm2(liver_);
    return draw(where([&](std::size_t at, const Eigen::Vector3i& v) {
                  return away2[at] > kNearest * kNearest && away2[at] < kFarthest * kFarthest && is_soft(v);
                }),
                count, kOutsideApart);
  }

  /// A line drawn across a body of voxels.
  struct Drag {
    Points middle;
    double mm = 0.0;
  };
  Drag across(const LabelMap& truth, Label label) {
    std::vector<long> in_slice(static_cast<std::size_t>(grid_.size.z()), 0);
    const std::vector<std::uint8_t> body = truth.voxels.mask([&](Label other) { return other == label; });
    const auto slice_size =
        static_cast<std::size_t>(grid_.size.x()) * static_cast<std::size_t>(grid_.size.y());
    for (std::size_t at = 0; at < body.size(); ++at) in_slice[at / slice_size] += body[at];
    const auto most = std::max_element(in_slice.begin(), in_slice.end()) - in_slice.begin();
    Mask slice({grid_.size.x(), grid_.size.y(), 1}, grid_.spacing_mm);
    std::copy_n(body.begin() + most * static_cast<std::ptrdiff_t>(slice_size), slice_size,
                slice.voxels.begin());
    const segmentation::LongestDiameter line = segmentation::longest_diameter(slice);
    const auto end = [&](Eigen::Vector3d at) {
      at.z() = static_cast<double>(most);
      const Eigen::Vector2d slip = kSlip * line.mm * hand_.tremor2();
      at.head<2>() += slip.cwiseQuotient(grid_.spacing_mm.head<2>());
      return grid_.p_in_ct(at).xyz;
    };
    const Eigen::Vector3d from = end(line.from.cast<double>()), to = end(line.to.cast<double>());
    return {0.5 * (from + to).transpose(), 1e3 * (to - from).norm()};
  }

  /// Within the inner half of a body of voxels.
  Points middle_of(const LabelMap& truth, Label label) {
    Mask body(grid_.size, grid_.spacing_mm);
    body.voxels = truth.voxels.mask([&](Label other) { return other == label; });
    const std::vector<float> depth2 = squared_depth_mm2(body);
    float deepest = 0.0F;
    for (std::size_t at = 0; at < depth2.size(); ++at)
      if (body.voxels[at] != 0) deepest = std::max(deepest, depth2[at]);
    return draw(where([&](std::size_t at, const Eigen::Vector3i&) {
                  return body.voxels[at] != 0 && depth2[at] >= 0.25F * deepest;
                }),
                1, 0.0);
  }

 private:
  template <class Wanted>
  Voxels where(const Wanted& wanted) const {
    Voxels found;
    std::size_t at = 0;
    for (int k = 0; k < grid_.size.z(); ++k)
      for (int j = 0; j < grid_.size.y(); ++j)
        for (int i = 0; i < grid_.size.x(); ++i, ++at)
          if (wanted(at, Eigen::Vector3i(i, j, k))) found.emplace_back(i, j, k);
    return found;
  }
  Eigen::Vector3d place(const Eigen::Vector3i& v) const { return grid_.p_in_ct(v.cast<double>()).xyz; }
  bool is_soft(const Eigen::Vector3i& v) const {
    for (int axis = 0; axis < 3; ++axis)
      for (const int side : {-1, 0, 1}) {
        const int step = static_cast<int>(std::lround(kAround / grid_.spacing_mm[axis]));
        const Eigen::Vector3i at = v + side * std::max(1, step) * Eigen::Vector3i::Unit(axis);
        if (!grid_.contains(at)) return false;
        const double hounsfield = (*ct_.voxels)[static_cast<std::size_t>(grid_.offset(at))];
        if (hounsfield < kSoftLow || hounsfield > kSoftHigh) return false;
      }
    return true;
  }
  Points draw(const Voxels& places, int count, double apart_mm) {
    std::vector<Eigen::Vector3d> chosen;
    for (int attempt = 0; attempt < 400 && static_cast<int>(chosen.size()) < count && !places.empty();
         ++attempt) {
      const Eigen::Vector3d p = place(places[hand_.draw(places.size())]);
      if (std::all_of(chosen.begin(), chosen.end(),
                      [&](const Eigen::Vector3d& other) { return 1e3 * (other - p).norm() >= apart_mm; }))
        chosen.push_back(p);
    }
    Points points(static_cast<Eigen::Index>(chosen.size()), 3);
    for (std::size_t n = 0; n < chosen.size(); ++n)
      points.row(static_cast<Eigen::Index>(n)) = chosen[n].transpose();
    return points;
  }

  const Image& ct_;
  const VolumeGrid& grid_;
  Hand hand_;
  Mask liver_;
};

}  // namespace

void LaypersonOptions::validate() const {
  const OptionCheck demand("layperson");
  demand(inside >= 1, "inside", inside, "Give one click at least");
  demand(outside >= 0, "outside", outside, "Give 0 clicks or more");
  demand(least_lesion_ml >= 0.0, "least_lesion_ml", least_lesion_ml, "Give a volume from zero, in ml");
}

void split_lesions(LabelMap& truth, double least_ml) {
  const VolumeGrid& grid = truth.voxels.grid();
  Mask tumours(grid.size, grid.spacing_mm);
  tumours.voxels = truth.voxels.mask(is_lesion);
  std::vector<long> sizes;
  const std::vector<int> body = connected_components(tumours, sizes);
  int last = 0;
  for (const long size : sizes)
    last += 1e-3 * static_cast<double>(size) * grid.voxel_volume_mm3() >= least_ml;
  std::vector<Label> labels = truth.voxels.dense();
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (body[i] > 0) labels[i] = static_cast<Label>(structure::kFirstLesion + std::min(body[i] - 1, last));
  truth.voxels = LabelVolume(grid, labels);
}

segmentation::Seeds click_as_layperson(const Image& ct, const LabelMap& truth,
                                       const LaypersonOptions& options) {
  options.validate();
  Eye eye(ct, truth, options.seed);
  segmentation::Seeds seeds;
  seeds.liver = eye.inside(options.inside);
  seeds.background = eye.outside(options.outside);
  const std::vector<long> counts = truth.voxels.histogram();
  for (std::size_t label = 0; label < counts.size(); ++label) {
    const auto code = static_cast<Label>(label);
    if (!is_lesion(code)) continue;
    const double ml = 1e-3 * static_cast<double>(counts[label]) * ct.grid.voxel_volume_mm3();
    if (counts[label] == 0 || ml < options.least_lesion_ml) continue;
    if (!options.draws_lesions) {
      seeds.lesions.push_back(eye.middle_of(truth, code));
      continue;
    }
    const auto [middle, mm] = eye.across(truth, code);
    seeds.lesions.push_back(middle);
    seeds.lesion_diameters_mm.push_back(
        std::clamp(mm, segmentation::Seeds::kLeastDiameter, segmentation::Seeds::kMostDiameter));
  }
  return seeds;
}

namespace {

/// The deepest voxel of a body, and how deep it lies, mm; 0: there is none.
struct Deepest {
  Eigen::Vector3i voxel = Eigen::Vector3i::Zero();
  float mm2 = 0.0F;
};
Deepest deepest_of(const Mask& body) {
  Deepest deepest;
  const VoxelBox box =
      bounding_box(body.size, body.spacing_mm, body.voxels, 2.0 * body.spacing_mm.maxCoeff());
  if (box.empty()) return deepest;
  const std::vector<float> depth2 = squared_depth_mm2(crop(body.size, body.spacing_mm, body.voxels, box));
  std::size_t at = 0;
  for (int k = 0; k < box.size().z(); ++k)
    for (int j = 0; j < box.size().y(); ++j)
      for (int i = 0; i < box.size().x(); ++i, ++at)
        if (depth2[at] > deepest.mm2 && std::isfinite(depth2[at]))
          deepest = {box.low + Eigen::Vector3i(i, j, k), depth2[at]};
  return deepest;
}

}  // namespace

std::optional<segmentation::Click> correct_as_layperson(const LabelMap& truth, const LabelMap& labels,
                                                        std::uint64_t seed) {
  constexpr double kOff = 2.0;  // mm
  const VolumeGrid& grid = truth.voxels.grid();
  require_same_grid(labels.voxels.grid(), grid, "labels that are corrected, and the truth");
  const std::vector<std::uint8_t> is = inside_liver(truth), found = inside_liver(labels);
  Mask missing(grid.size, grid.spacing_mm), wrong = missing;
  for (std::size_t i = 0; i < is.size(); ++i) {
    missing.voxels[i] = is[i] != 0 && found[i] == 0;
    wrong.voxels[i] = is[i] == 0 && found[i] != 0;
  }
  const Deepest in = deepest_of(missing), out = deepest_of(wrong);
  const bool is_liver = in.mm2 >= out.mm2;
  const Eigen::Vector3i middle = is_liver ? in.voxel : out.voxel;
  if ((is_liver ? in : out).mm2 <= 0.0F) return {};
  Hand hand(seed);
  for (int attempt = 0; attempt < 20; ++attempt) {
    const Eigen::Vector3d index =
        middle.cast<double>() + kOff * hand.tremor3().cwiseQuotient(grid.spacing_mm);
    const Eigen::Vector3i voxel = index.array().round().matrix().cast<int>();
    if (!grid.contains(voxel)) continue;
    if ((is[static_cast<std::size_t>(grid.offset(voxel))] != 0) == is_liver)
      return segmentation::Click{grid.p_in_ct(index), is_liver};
  }
  return segmentation::Click{grid.p_in_ct(middle.cast<double>()), is_liver};
}

}  // namespace glisson::insilico
