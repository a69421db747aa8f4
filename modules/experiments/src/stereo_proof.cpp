// SPDX-License-Identifier: GPL-3.0-or-later
#include "stereo_proof.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "glisson/geometry/mesh_io.h"
#include "glisson/stereo/board_series.h"
#include "glisson/stereo/calibrate.h"
#include "glisson/stereo/calibration_io.h"
#include "glisson/stereo/density.h"
#include "glisson/stereo/evaluate.h"
#include "glisson/stereo/faults.h"
#include "glisson/stereo/picture_io.h"
#include "glisson/stereo/reconstruct_pair.h"
#include "real_pairs.h"
#include "stereo_theatre.h"

namespace glisson::experiments {
namespace fs = std::filesystem;
namespace {

Cancellable<stereo::Reconstructed> reconstruct(const RealPair& pair, stereo::Method method,
                                               stereo::Features kind, const RunContext& context) {
  stereo::ReconstructOptions options;
  options.method = method;
  options.kind = kind;
  options.points_per_cm2 = 40.0;  // the region is small: that many for its statistics
  auto made = stereo::reconstruct_pair({{pair.left, pair.right}, pair.rig, pair.mask, {}}, options, context);
  if (!made) return {};
  return *made->whole;
}

/// Blue: too near; red: too far; white: right. Full colour at 2 mm.
Dot dot_of(const Eigen::Vector2d& pixel, double error) {
  constexpr double kFull = 2e-3;
  const double t = std::clamp(error / kFull, -1.0, 1.0);
  const auto faded = [](double x) { return static_cast<std::uint8_t>(std::lround(255.0 * (1.0 - x))); };
  const std::uint8_t red = faded(std::max(0.0, -t)), blue = faded(std::max(0.0, t));
  return {pixel.x(), pixel.y(), blue, faded(std::abs(t)), red};
}

void draw_errors(const fs::path& path, const RealPair& pair, const LabelledCloud& cloud,
                 const std::vector<double>& errors) {
  std::vector<Dot> dots;
  for (int i = 0; i < cloud.size(); ++i)
    if (std::isfinite(errors[static_cast<std::size_t>(i)]))
      dots.push_back(dot_of(pair.rig.left.project(cloud.points.row(i).transpose()),
                            errors[static_cast<std::size_t>(i)]));
  stereo::write_picture(path, with_dots(pair.left, dots));
}

double share_within(const std::vector<double>& errors, double most) {
  return static_cast<double>(std::count_if(errors.begin(), errors.end(),
                                           [&](double error) { return std::abs(error) <= most; })) /
         std::max(1.0, static_cast<double>(errors.size()));
}

/// Median of the error without an offset that all methods have.
double median_without(std::vector<double> errors, double offset) {
  std::erase_if(errors, [](double error) { return !std::isfinite(error); });
  for (double& error : errors) error = std::abs(error - offset);
  return summarise(std::move(errors)).median;
}

struct Way {
  const char* name;
  stereo::Method method;
  stereo::Features kind;
};
constexpr Way kWays[] = {{"sparse", stereo::Method::sparse, stereo::Features::surf},
                         {"sift", stereo::Method::sparse, stereo::Features::sift},
                         {"akaze", stereo::Method::sparse, stereo::Features::akaze},
                         {"dense", stereo::Method::dense, stereo::Features::surf}};

bool prove_opencas(const fs::path& data, const fs::path& folder, StereoProof& proof,
                   const RunContext& context) {
  const RealPair pair = opencas(data, OpencasPart::with_truth);
  std::vector<stereo::Reconstructed> made;
  for (const Way& way : kWays) {
    auto result = reconstruct(pair, way.method, way.kind, context.quiet());
    if (!result) return false;
    made.push_back(std::move(*result));
  }
  // The truth, after everything else.
  const TriangleMesh surface =
      read_triangle_mesh(data / "Stereo_SD_d_complete_22_CT_cut.stl", LengthUnit::millimetre);
  std::vector<stereo::CloudErrors> errors;
  double offset = 0.0;
  for (const stereo::Reconstructed& one : made) {
    errors.push_back(stereo::cloud_errors(one.cloud, surface));
    offset += errors.back().bias / static_cast<double>(made.size());
  }
  proof.figures["opencas_common_offset_mm"] = 1e3 * offset;
  for (std::size_t i = 0; i < made.size(); ++i) {
    const std::string key = std::string("opencas_") + kWays[i].name + "_";
    const stereo::DensityMap density = stereo::density_map(made[i].cloud, pair.rig.left, pair.mask, {});
    proof.figures[key + "points"] = made[i].cloud.size();
    proof.figures[key + "median_mm"] = 1e3 * errors[i].distance.median;
    proof.figures[key + "p95_mm"] = 1e3 * errors[i].distance.percentile_95;
    proof.figures[key + "within_3mm_share"] = share_within(errors[i].errors, 3e-3);
    proof.figures[key + "without_offset_median_mm"] = 1e3 * median_without(errors[i].errors, offset);
    proof.figures[key + "bias_mm"] = 1e3 * errors[i].bias;
    proof.figures[key + "covered_share"] = density.covered;
    proof.figures[key + "per_cm2"] = made[i].report.density_per_cm2;
    draw_errors(folder / (key + "errors.png"), pair, made[i].cloud, errors[i].errors);
    stereo::write_picture(folder / (key + "density.png"), stereo::density_picture(density, pair.left));
  }
  return true;
}

bool prove_chessboard(const fs::path& data, const fs::path& folder, StereoProof& proof,
                      const RunContext& context) {
  stereo::BoardSearch search;
  search.left = data;
  const auto views = stereo::find_views(search, context.part(0.0, 0.8));
  if (!views) return false;
  stereo::CalibrateOptions options;
  options.reference = stereo::read_text_calibration(data, views->width(), views->height());
  const auto calibration = stereo::calibrate(*views, options, context.part(0.8, 1.0));
  if (!calibration) return false;
  const auto better =
      std::count_if(calibration->views.begin(), calibration->views.end(),
                    [](const auto& view) { return view.epipolar_left_out < view.epipolar_reference; });
  proof.figures["chessboard_pairs"] = views->pairs();
  proof.figures["chessboard_views"] = static_cast<double>(views->views().size());
  proof.figures["chessboard_rms_px"] = calibration->rms;
  proof.figures["chessboard_epipolar_left_out_px"] = calibration->epipolar_left_out;
  proof.figures["chessboard_epipolar_reference_px"] = calibration->epipolar_reference;
  proof.figures["chessboard_views_better_share"] =
      static_cast<double>(better) / std::max(1.0, static_cast<double>(calibration->views.size()));
  proof.figures["chessboard_baseline_mm"] = 1e3 * calibration->rig.baseline();
  stereo::write_picture(folder / "chessboard_coverage.png", stereo::coverage_picture(*views, *calibration));
  return true;
}

bool prove_heart(const fs::path& data, const fs::path& folder, StereoProof& proof,
                 const RunContext& context) {
  const RealPair pair = heart(data);
  const stereo::PairCheck check = stereo::check_pair(pair.left, pair.right, pair.rig);
  proof.figures["heart_faults"] = static_cast<double>(check.faults.size());
  for (const Way& way : kWays) {
    const auto made = reconstruct(pair, way.method, way.kind, context.quiet());
    if (!made) return false;
    const std::string key = std::string("heart_") + way.name + "_";
    const stereo::DensityMap density = stereo::density_map(made->cloud, pair.rig.left, pair.mask, {});
    proof.figures[key + "points"] = made->cloud.size();
    proof.figures[key + "epipolar_rms_px"] = made->report.epipolar_rms_px;
    proof.figures[key + "covered_share"] = density.covered;
    stereo::write_picture(folder / (key + "density.png"), stereo::density_picture(density, pair.left));
  }
  return true;
}

}  // namespace

Cancellable<StereoProof> prove_stereo(const StereoProofOptions& options, const fs::path& folder,
                                      const RunContext& context) {
  StereoProof proof;
  using Prove = bool (*)(const fs::path&, const fs::path&, StereoProof&, const RunContext&);
  constexpr std::pair<const char*, Prove> kSets[] = {{"stereo_opencas", prove_opencas},
                                                     {"stereo_heart", prove_heart},
                                                     {"stereo_chessboard", prove_chessboard}};
  double done = 0.0;
  for (const auto& [name, prove] : kSets) {
    const fs::path data = options.data / name;
    if (options.data.empty() || !fs::exists(data))
      proof.absent.emplace_back(name);
    else if (!prove(data, folder, proof, context.part(done, done + 0.2)))
      return std::nullopt;
    done += 0.2;
  }
  if (options.theatre && !prove_in_theatre(options, folder, proof, context.part(done, 1.0)))
    return std::nullopt;
  return proof;
}

}  // namespace glisson::experiments
