// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "glisson/core/error.h"
#include "glisson/insilico/operator.h"
#include "operator_hand.h"

namespace glisson::insilico {
namespace {

using Voxels = std::vector<Eigen::Vector3i>;

constexpr int kCandidates = 600;  // looked at per structure: enough to find its thick parts

/// The voxels of every structure, at most `kCandidates` of each, evenly through the list.
std::map<Label, Voxels> candidates_of(const LabelMap& truth) {
  const std::vector<long> counts = truth.voxels.histogram();
  std::map<Label, Voxels> found;
  std::map<Label, long> passed;
  const std::vector<Label> dense = truth.voxels.dense();
  const Eigen::Vector3i size = truth.voxels.grid().size;
  std::size_t at = 0;
  for (int k = 0; k < size.z(); ++k)
    for (int j = 0; j < size.y(); ++j)
      for (int i = 0; i < size.x(); ++i, ++at) {
        const Label label = dense[at];
        if (label == structure::kBackground) continue;
        const long stride = std::max(1L, counts[label] / kCandidates);
        if (passed[label]++ % stride == stride / 2) found[label].emplace_back(i, j, k);
      }
  return found;
}

/// How far from voxel v the label goes in the tightest of 26 directions, mm: how deep inside it one is.
double clearance_mm(const LabelMap& truth, const Eigen::Vector3i& v, Label label) {
  const VolumeGrid& grid = truth.voxels.grid();
  const double step = 0.5 * grid.spacing_mm.minCoeff();
  double least = 60.0;
  for (int dz = -1; dz <= 1; ++dz)
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        if (dx == 0 && dy == 0 && dz == 0) continue;
        const Eigen::Vector3d way = Eigen::Vector3d(dx, dy, dz).normalized().cwiseQuotient(grid.spacing_mm);
        double s = 0.0;
        while (s < least) {
          const Eigen::Vector3i u = (v.cast<double>() + (s + step) * way).array().round().cast<int>();
          if (!grid.contains(u) || truth.voxels.at(u) != label) break;
          s += step;
        }
        least = std::min(least, s);
      }
  return least;
}

struct Depth {
  double clearance = 0.0;
  Eigen::Vector3d p_mm;
};

/// The deepest candidates, at least `apart_mm` from one another.
std::vector<Depth> deepest(const LabelMap& truth, const Voxels& voxels, Label label, int count,
                           double apart_mm) {
  std::vector<Depth> all;
  for (const Eigen::Vector3i& v : voxels)
    all.push_back({clearance_mm(truth, v, label), 1e3 * truth.voxels.grid().p_in_ct(v.cast<double>()).xyz});
  std::stable_sort(all.begin(), all.end(),
                   [](const Depth& a, const Depth& b) { return a.clearance > b.clearance; });
  std::vector<Depth> chosen;
  for (const Depth& depth : all) {
    if (static_cast<int>(chosen.size()) >= count) break;
    if (std::all_of(chosen.begin(), chosen.end(),
                    [&](const Depth& other) { return (other.p_mm - depth.p_mm).norm() >= apart_mm; }))
      chosen.push_back(depth);
  }
  return chosen;
}

class Clicker {
 public:
  Clicker(const LabelMap& truth, const OperatorOptions& options)
      : truth_(truth), noise_mm_(options.click_noise_mm), hand_(options.seed) {}

  /// One click; made again where the noise leads off the structure.
  Eigen::Vector3d click(const Eigen::Vector3d& p_mm, Label label) {
    for (int attempt = 0; attempt < 20; ++attempt) {
      const Eigen::Vector3d clicked = p_mm + noise_mm_ * hand_.tremor3();
      if (label_at(clicked) == label) return 1e-3 * clicked;
    }
    return 1e-3 * p_mm;
  }
  Points click(const std::vector<Depth>& wanted, Label label) {
    Points points(static_cast<Eigen::Index>(wanted.size()), 3);
    for (std::size_t i = 0; i < wanted.size(); ++i)
      points.row(static_cast<Eigen::Index>(i)) = click(wanted[i].p_mm, label).transpose();
    return points;
  }
  /// Points 10 to 25 mm beside the liver.
  Points beside(const Voxels& liver, int count) {
    Points points(count, 3);
    Eigen::Index found = 0;
    for (int attempt = 0; attempt < 200 * count && found < count; ++attempt) {
      const Eigen::Vector3i& v = liver[hand_.draw(liver.size())];
      Eigen::Vector3d p = 1e3 * truth_.voxels.grid().p_in_ct(v.cast<double>()).xyz;
      const Eigen::Vector3d way = hand_.tremor3().normalized();
      double out_mm = 0.0;  // since the structure was left for good
      const double wanted_mm = 10.0 + 15.0 * hand_.uniform();
      for (int step = 0; step < 300 && out_mm < wanted_mm; ++step) {
        p += way;
        out_mm = label_at(p) == structure::kBackground ? out_mm + 1.0 : 0.0;
      }
      if (out_mm >= wanted_mm && truth_.voxels.grid().contains(voxel(p)))
        points.row(found++) = 1e-3 * p.transpose();
    }
    points.conservativeResize(found, 3);
    return points;
  }

 private:
  Eigen::Vector3i voxel(const Eigen::Vector3d& p_mm) const {
    return truth_.voxels.grid().index_of(Point<CtFrame>(1e-3 * p_mm)).array().round().cast<int>();
  }
  Label label_at(const Eigen::Vector3d& p_mm) const {
    const Eigen::Vector3i v = voxel(p_mm);
    return truth_.voxels.grid().contains(v) ? truth_.voxels.at(v) : structure::kBackground;
  }

  const LabelMap& truth_;
  double noise_mm_;
  Hand hand_;
};

}  // namespace

void OperatorOptions::validate() const {
  if (!(click_noise_mm >= 0.0 && click_noise_mm <= 20.0))
    throw InputError("operator", "click_noise_mm", std::to_string(click_noise_mm) + " is out of range",
                     "give 0 to 20 mm");
  if (!(click_noise_px >= 0.0 && click_noise_px <= 50.0))
    throw InputError("operator", "click_noise_px", std::to_string(click_noise_px) + " is out of range",
                     "give 0 to 50 pixels");
}

segmentation::Seeds click_seeds(const LabelMap& truth, const OperatorOptions& options) {
  options.validate();
  const std::map<Label, Voxels> candidates = candidates_of(truth);
  if (!candidates.contains(structure::kParenchyma))
    throw InputError("label map", "liver", "no voxel is parenchyma", "give the labels of a liver");
  Clicker clicker(truth, options);
  segmentation::Seeds seeds;
  const auto clicks = [&](Label label, int count, double apart_mm) {
    const auto found = candidates.find(label);
    if (found == candidates.end()) return Points(0, 3);
    return clicker.click(deepest(truth, found->second, label, count, apart_mm), label);
  };
  seeds.liver = clicks(structure::kParenchyma, 6, 35.0);
  // The thickest parts are at the roots: the main portal trunk, the hepatic veins at the cava.
  seeds.portal_vein = clicks(structure::kPortalVein, 3, 12.0);
  seeds.hepatic_veins = clicks(structure::kHepaticVeins, 4, 12.0);
  seeds.vena_cava = clicks(structure::kVenaCava, 2, 25.0);
  seeds.gallbladder = clicks(structure::kGallbladder, 1, 0.0);
  for (const auto& [label, voxels] : candidates)
    if (is_lesion(label)) seeds.lesions.push_back(clicks(label, 1, 0.0));
  seeds.background = clicker.beside(candidates.at(structure::kParenchyma), 8);
  return seeds;
}

}  // namespace glisson::insilico
