// SPDX-License-Identifier: GPL-3.0-or-later
#include "mr_scale.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "bias_field.h"
#include "bodies.h"
#include "glisson/core/error.h"
#include "glisson/core/statistics.h"
#include "painting.h"

namespace glisson::segmentation {
namespace {

constexpr double kCoarse = 6.0;      // mm: a coil's field changes over a decimetre
constexpr double kHollow = 15.0;     // mm: dark seams of that width lie inside the body
constexpr double kDarkShare = 0.05;  // of the body: less than the fat and air that any trunk holds
constexpr double kSeedRadius = 6.0, kVesselRadius = 2.0;  // mm
/// Of a difference in deviations, from which on it is seen for sure (Rose 1948).
constexpr double kSeen = 5.0;
/// What the tissue model takes for a venous liver and for fat, HU.
constexpr double kLiver = 110.0, kFat = -100.0;
/// Nothing of an MRI is emptier than fat: its air is no lung of a CT.
constexpr double kDarkest = -140.0, kBrightest = 1500.0;
/// Over the dark, in livers: the body's brightest hundredth. In the venous phase kidneys, spleen and vessels
/// are not twice as bright as the liver; on T2 fluid, bowel and kidneys are several times as bright.
constexpr double kBrightShare = 0.99, kMostBright = 2.0;

const char* const kWanted =
    "Open a T1 series with fat suppression in the venous phase, or import labels instead";

/// The threshold between two classes of values that leaves least variance within them (Otsu 1979).
float otsu(const std::vector<float>& values) {
  constexpr std::size_t kBins = 256;
  const float top = upper_percentile(values, 0.999);
  std::array<double, kBins> counts{};
  const auto bin = [&](float v) {
    return static_cast<std::size_t>(std::clamp(v / std::max(top, 1.0F) * kBins, 0.0F, kBins - 1.0F));
  };
  double all = 0.0;
  for (const float v : values) counts[bin(v)] += 1.0, all += static_cast<double>(bin(v));
  double below = 0.0, sum = 0.0, best = -1.0;
  std::size_t at = 0;
  const auto n = static_cast<double>(values.size());
  for (std::size_t b = 0; b + 1 < kBins; ++b) {
    below += counts[b];
    sum += counts[b] * static_cast<double>(b);
    if (below == 0.0 || below == n) continue;
    const double apart = sum / below - (all - sum) / (n - below),
                 between = below * (n - below) * apart * apart;
    if (between > best) best = between, at = b;
  }
  return static_cast<float>(at + 1) * std::max(top, 1.0F) / static_cast<float>(kBins);
}

/// An MRI without its bias field, on coarse voxels.
struct Evened {
  Field coarse;  ///< corrected
  Field bias;
  Mask body;
};

Cancellable<Evened> evened(const Image& image, const RunContext& context) {
  Evened result;
  result.coarse = resampled(image, {Eigen::Vector3i::Zero(), image.grid.size}, kCoarse);
  Field& coarse = result.coarse;
  for (float& value : coarse.values) value = std::max(value, 1.0F);
  const float threshold = otsu(coarse.values);
  Mask tissue = coarse.empty_mask();
  for (std::size_t i = 0; i < tissue.voxels.size(); ++i) tissue.voxels[i] = coarse.values[i] > threshold;
  auto bias = bias_field(coarse, tissue, context);
  if (!bias) return std::nullopt;
  result.bias = std::move(*bias);
  for (std::size_t i = 0; i < coarse.values.size(); ++i) coarse.values[i] /= result.bias.values[i];
  // Not closed(): the body goes on beyond the picture, so that its hollows are shut there, too.
  result.body = holes_filled(largest_component(eroded(dilated(tissue, kHollow), kHollow)));
  return result;
}

std::vector<float> within(const Evened& mr, const Mask& mask) {
  std::vector<float> values;
  for (std::size_t i = 0; i < mask.voxels.size(); ++i)
    if (mask.voxels[i] != 0) values.push_back(mr.coarse.values[i]);
  return values;
}

/// The whole image without its bias field, with its clicks.
class Corrected {
 public:
  Corrected(const Image& image, const Evened& mr) {
    const VoxelBox box{Eigen::Vector3i::Zero(), image.grid.size};
    field_.size = image.grid.size;
    field_.spacing_mm = image.grid.spacing_mm;
    field_.values = on_image(mr.bias, box);
    for (std::size_t i = 0; i < field_.values.size(); ++i)
      field_.values[i] = static_cast<float>((*image.voxels)[i]) / field_.values[i];
    grid_ = image.grid;
  }
  const Field& field() const { return field_; }
  Tissue around(const Points& points, double radius_mm) const {
    constexpr double kAnySigma = 1e9;
    std::vector<float> means, sigmas;
    for (const Eigen::Vector3i& place : voxels_of(grid_, field_, points)) {
      const Tissue one = tissue_around(field_, {place}, radius_mm, 0.0, kAnySigma);
      means.push_back(static_cast<float>(one.mean));
      sigmas.push_back(static_cast<float>(one.sigma));
    }
    return {upper_median(means), upper_median(sigmas)};
  }

 private:
  Field field_;
  VolumeGrid grid_;
};

/// Where the liver lies between the dark and the bright.
struct Anchors {
  Tissue liver;
  double dark = 0.0;
};

Tissue liver_of(const Evened& mr, const Corrected& corrected, const Image& image, const Seeds& seeds,
                const LabelMap* kept) {
  if (seeds.liver.rows() > 0) return corrected.around(seeds.liver, kSeedRadius);
  std::vector<float> values;
  if (kept != nullptr)
    values =
        within(mr, sampled(image.grid, kept->voxels.mask([](Label l) { return l == structure::kParenchyma; }),
                           mr.coarse));
  if (values.empty())
    throw InputError("seeds", "liver", "has no point", "Click at least one point inside the liver");
  const auto [middle, deviation] = robust_spread(std::move(values));
  return {middle, deviation};
}

void check_vessels(const Corrected& corrected, const Seeds& seeds, const Anchors& anchors) {
  for (const auto& [points, name] : {std::pair<const Points*, const char*>{&seeds.portal_vein, "portal_vein"},
                                     {&seeds.hepatic_veins, "hepatic_veins"},
                                     {&seeds.vena_cava, "vena_cava"}}) {
    if (points->rows() == 0) continue;
    if (corrected.around(*points, kVesselRadius).mean <= anchors.liver.mean)
      throw InputError("seeds", name, "is not brighter than the liver in this MRI", kWanted);
  }
}

Anchors anchors_of(const Evened& mr, const Corrected& corrected, const Image& image, const Seeds& seeds,
                   const LabelMap* kept) {
  const std::vector<float> body = within(mr, mr.body);
  if (body.empty()) throw InputError("image", "", "shows no body", kWanted);
  Anchors anchors{liver_of(mr, corrected, image, seeds, kept), lower_percentile(body, kDarkShare)};
  const double height = anchors.liver.mean - anchors.dark;
  if (!(height > kSeen * anchors.liver.sigma) || height <= 0.0)
    throw InputError("seeds", "liver", "hardly stands out from fat and air in this MRI", kWanted);
  check_vessels(corrected, seeds, anchors);
  const double bright = (upper_percentile(body, kBrightShare) - anchors.dark) / height;
  if (bright > kMostBright)
    throw InputError("image", "", "shows much that is far brighter than the liver", kWanted);
  return anchors;
}

}  // namespace

Cancellable<Image> on_ct_scale(const Image& image, const Seeds& seeds, const LabelMap* kept,
                               const RunContext& context) {
  if (image.modality == Modality::ct) return image;
  if (image.modality != Modality::mr)
    throw InputError("image", "modality", "is not known: nothing tells what its grey values mean",
                     "Import it again and say whether it is CT or MRI, or import labels instead");
  const auto mr = evened(image, context);
  if (!mr) return std::nullopt;
  const Corrected corrected(image, *mr);
  const Anchors anchors = anchors_of(*mr, corrected, image, seeds, kept);
  const double scale = (kLiver - kFat) / (anchors.liver.mean - anchors.dark);
  std::vector<std::int16_t> voxels;
  voxels.reserve(image.voxels->size());
  for (const float value : corrected.field().values)
    voxels.push_back(static_cast<std::int16_t>(
        std::lround(std::clamp(kFat + scale * (value - anchors.dark), kDarkest, kBrightest))));
  Image mapped = image;
  mapped.modality = Modality::ct;
  mapped.voxels = std::make_shared<const std::vector<std::int16_t>>(std::move(voxels));
  return mapped;
}

}  // namespace glisson::segmentation
