// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/insilico/altered_ct.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "glisson/core/error.h"
#include "glisson/core/statistics.h"
#include "glisson/volume/morphology.h"
#include "liver_shape.h"

namespace glisson::insilico {
namespace {

constexpr double kBulge = 3.0;       // mm that a tumour may stand out of the organ
constexpr double kEdge = 1.0;        // mm, half the width of a tumour's edge in the picture
constexpr double kTexture = 4.0;     // mm, half the side of the square that a voxel's own noise is told from
constexpr double kMostNoise = 40.0;  // HU; more of a difference is a vessel's or an organ's edge
constexpr double kEmpty = -150.0;    // HU below which is lung or gas
constexpr double kApart = 4.0;       // mm between two tumours

/// A CT that is being altered. Points are LPS millimetres.
class Alterer {
 public:
  Alterer(const Image& ct, const LabelMap& truth, std::uint64_t seed)
      : grid_(ct.grid),
        voxels_(*ct.voxels),
        labels_(truth.voxels.dense()),
        description_(ct.description),
        random_(RunContext({}, nullptr, seed).random("insilico.altered_ct")) {
    Mask liver(grid_.size, grid_.spacing_mm);
    liver.voxels = inside_liver(truth);
    depth2_ = squared_depth_mm2(liver);
    beyond2_ = squared_distance_mm2(liver);
    Mask cava(grid_.size, grid_.spacing_mm);
    cava.voxels = truth.voxels.mask([](Label label) { return label == structure::kVenaCava; });
    cava2_ = squared_distance_mm2(cava);
    std::vector<double> tissue;
    for (std::size_t at = 0; at < labels_.size(); ++at)
      if (labels_[at] == structure::kParenchyma) tissue.push_back(voxels_[at]);
    if (tissue.empty())
      throw InputError("label map", "liver", "no voxel is parenchyma", "give the labels of a liver");
    std::sort(tissue.begin(), tissue.end());
    liver_hu_ = interpolated_percentile(tissue, 0.5);
    for (const Label label : labels_)
      if (is_lesion(label)) next_ = std::max(next_, static_cast<Label>(label + 1));
  }

  void put(const LesionKind& kind, double contrast) {
    Lesion body{centre_for(kind), Vec::Ones()};
    const double a = between(0.88, 1.12), b = between(0.88, 1.12);
    body.half_axes = kind.radius_mm * Vec(a, b, 1.0 / (a * b));
    body.phase = between(0.0, 6.0);
    placed_.push_back(body);
    const std::vector<std::int16_t> before = voxels_;
    each_near(body, [&](std::size_t at, const Eigen::Vector3i& voxel) {
      const double field = shown_field(body, at, voxel);
      const double share = 1.0 - smooth_step(-kEdge, kEdge, field);
      if (share <= 0.0) return;
      const double own = std::clamp(before[at] - local_mean(before, voxel), -kMostNoise, kMostNoise);
      const double look = look_of(kind, contrast, body.field(centre(voxel))) + own;
      voxels_[at] = static_cast<std::int16_t>(std::lround(mix(voxels_[at], look, share)));
      if (field < 0.0) labels_[at] = next_;
    });
    ++next_;
  }

  void add_noise(double hu) {
    if (hu <= 0.0) return;
    for (auto& voxel : voxels_)
      voxel = static_cast<std::int16_t>(
          std::clamp(std::lround(voxel + hu * standard_normal(random_)), -1024L, 3071L));
  }

  PathologyCt joined(int slices) const {
    PathologyCt result;
    result.ct.grid = grid_;
    result.ct.grid.size.z() = grid_.size.z() / slices;
    result.ct.grid.spacing_mm.z() *= slices;
    result.ct.grid.origin_mm = 1e3 * grid_.p_in_ct(Vec(0.0, 0.0, 0.5 * (slices - 1))).xyz;
    result.ct.description = description_;
    const auto plane = static_cast<std::size_t>(grid_.size.x()) * static_cast<std::size_t>(grid_.size.y());
    const auto count = plane * static_cast<std::size_t>(result.ct.grid.size.z());
    std::vector<std::int16_t> voxels(count);
    std::vector<Label> labels(count);
    const auto each = static_cast<std::size_t>(slices);
    for (std::size_t at = 0; at < count; ++at) {
      const std::size_t first = at / plane * each * plane + at % plane;
      long sum = 0;
      for (std::size_t n = 0; n < each; ++n) sum += voxels_[first + n * plane];
      voxels[at] = static_cast<std::int16_t>(std::lround(static_cast<double>(sum) / slices));
      labels[at] = labels_[first + each / 2 * plane];
    }
    result.ct.voxels = std::make_shared<const std::vector<std::int16_t>>(std::move(voxels));
    result.truth.voxels = LabelVolume(result.ct.grid, labels);
    const std::vector<long> counts = result.truth.voxels.histogram();
    for (std::size_t label = 1; label < counts.size(); ++label)
      if (counts[label] > 0) result.truth.infos.push_back(structure_info(static_cast<Label>(label)));
    return result;
  }

 private:
  double between(double low, double high) { return low + (high - low) * uniform01(random_); }
  Vec centre(const Eigen::Vector3i& voxel) const { return 1e3 * grid_.p_in_ct(voxel.cast<double>()).xyz; }

  /// Whether a lesion's middle may lie there, by its distances from the liver's border and from the cava.
  bool may_lie(const LesionKind& kind, std::size_t at) const {
    const double depth = std::sqrt(depth2_[at]), r = kind.radius_mm;
    switch (kind.place) {
      case LesionKind::Place::deep:
        return depth > std::min(r + 3.0, deepest_ - 2.0);
      case LesionKind::Place::rim:
        return depth > 0.65 * r && depth < 0.8 * r;
      case LesionKind::Place::beside_cava:
        return depth > 0.5 * r && std::abs(std::sqrt(cava2_[at]) - 0.95 * r) < 2.0;
    }
    return false;
  }

  Vec centre_for(const LesionKind& kind) {
    deepest_ = std::sqrt(*std::max_element(depth2_.begin(), depth2_.end()));
    std::vector<Eigen::Vector3i> places;
    std::size_t at = 0;
    for (int k = 0; k < grid_.size.z(); ++k)
      for (int j = 0; j < grid_.size.y(); ++j)
        for (int i = 0; i < grid_.size.x(); ++i, ++at)
          if (depth2_[at] > 0.0F && may_lie(kind, at) && is_apart(kind, centre({i, j, k})))
            places.emplace_back(i, j, k);
    if (places.empty())
      throw InputError(
          "label map", "liver",
          "there is no place for a tumour of " + std::to_string(std::lround(kind.radius_mm)) + " mm",
          "give a larger liver, or its vena cava");
    return centre(places[static_cast<std::size_t>(uniform01(random_) * static_cast<double>(places.size()))]);
  }
  bool is_apart(const LesionKind& kind, const Vec& p) const {
    return std::all_of(placed_.begin(), placed_.end(), [&](const Lesion& other) {
      return (other.centre - p).norm() > other.reach() + 1.1 * kind.radius_mm + kApart;
    });
  }

  /// Negative where the tumour is seen: not far out of the organ, not in lung or gas, not in the cava.
  double shown_field(const Lesion& body, std::size_t at, const Eigen::Vector3i& voxel) const {
    const double outside = std::sqrt(beyond2_[at]) - kBulge;
    const bool barred = (beyond2_[at] > 0.0F && voxels_[at] < kEmpty) || cava2_[at] == 0.0F ||
                        labels_[at] == structure::kGallbladder;
    return barred ? kEdge : std::max(body.field(centre(voxel)), outside);
  }

  template <class Function>
  void each_near(const Lesion& body, const Function& function) const {
    const Vec reach = (Vec::Constant(body.reach() + 2.0).cwiseQuotient(grid_.spacing_mm));
    const Vec middle = grid_.index_of(Point<CtFrame>(1e-3 * body.centre));
    const Eigen::Vector3i low = (middle - reach).array().floor().cast<int>().max(0).matrix();
    const Eigen::Vector3i high =
        (middle + reach).array().ceil().cast<int>().min(grid_.size.array() - 1).matrix();
    for (int k = low.z(); k <= high.z(); ++k)
      for (int j = low.y(); j <= high.y(); ++j)
        for (int i = low.x(); i <= high.x(); ++i)
          function(static_cast<std::size_t>(grid_.offset({i, j, k})), Eigen::Vector3i(i, j, k));
  }

  double local_mean(const std::vector<std::int16_t>& of, const Eigen::Vector3i& voxel) const {
    const int ri = static_cast<int>(kTexture / grid_.spacing_mm.x()),
              rj = static_cast<int>(kTexture / grid_.spacing_mm.y());
    double sum = 0.0;
    int count = 0;
    for (int j = std::max(voxel.y() - rj, 0); j <= std::min(voxel.y() + rj, grid_.size.y() - 1); ++j)
      for (int i = std::max(voxel.x() - ri, 0); i <= std::min(voxel.x() + ri, grid_.size.x() - 1); ++i) {
        sum += of[static_cast<std::size_t>(grid_.offset({i, j, voxel.z()}))];
        ++count;
      }
    return sum / count;
  }

  double look_of(const LesionKind& kind, double contrast, double field) const {
    const double tumour = liver_hu_ - contrast;
    if (kind.look == LesionKind::Look::cyst) return 6.0;
    if (kind.look == LesionKind::Look::necrotic)
      return mix(tumour + 12.0, 22.0, smooth_step(-0.25 * kind.radius_mm, -0.5 * kind.radius_mm, field));
    return tumour;
  }

  VolumeGrid grid_;
  std::vector<std::int16_t> voxels_;
  std::vector<Label> labels_;
  std::string description_;
  std::mt19937_64 random_;
  std::vector<float> depth2_, beyond2_, cava2_;
  std::vector<Lesion> placed_;
  double liver_hu_ = 0.0, deepest_ = 0.0;
  Label next_ = structure::kFirstLesion;
};

}  // namespace

std::vector<Alteration> alterations() {
  using Look = LesionKind::Look;
  using Place = LesionKind::Place;
  return {
      {"two large tumours",
       {{Look::hypodense, Place::beside_cava, 26.0}, {Look::hypodense, Place::rim, 27.0}}},
      {"faint tumours", {{Look::hypodense, Place::rim, 22.0}, {Look::hypodense, Place::deep, 13.0}}, 25.0},
      {"necrotic", {{Look::necrotic, Place::rim, 32.0}}, 35.0},
      {"cysts", {{Look::cyst, Place::rim, 26.0}, {Look::cyst, Place::deep, 12.0}}},
      {"slices of three", {}, 45.0, 3},
      {"noise", {}, 45.0, 1, 25.0},
      {"tumours, slices of three",
       {{Look::hypodense, Place::rim, 25.0}, {Look::hypodense, Place::deep, 13.0}},
       45.0,
       3,
       10.0}};
}

Cancellable<PathologyCt> altered_ct(const Image& ct, const LabelMap& truth, const Alteration& alteration,
                                    std::uint64_t seed, const RunContext& context) {
  Alterer alterer(ct, truth, seed);
  for (const LesionKind& kind : alteration.lesions) {
    if (context.cancelled()) return {};
    alterer.put(kind, alteration.lesion_contrast_hu);
  }
  alterer.add_noise(alteration.noise_hu);
  if (context.cancelled()) return {};
  return alterer.joined(alteration.slices_joined);
}

}  // namespace glisson::insilico
