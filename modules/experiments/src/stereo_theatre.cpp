// SPDX-License-Identifier: GPL-3.0-or-later
#include "stereo_theatre.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string_view>

#include "glisson/core/files.h"
#include "glisson/core/statistics.h"
#include "glisson/insilico/patient.h"
#include "glisson/insilico/theatre.h"
#include "glisson/stereo/evaluate.h"
#include "glisson/stereo/reconstruct_pair.h"

namespace glisson::experiments {
namespace {

/// One row of the table.
struct Trial {
  const char* name;
  double distance_mm;
  Hardship hardship;
};
constexpr Trial kTrials[] = {
    {"near", 90.0, {}},
    {"middle", 120.0, {}},
    {"far", 155.0, {}},
    {"noise_3", 120.0, {3.0, 1.0, 0}},
    {"noise_8", 120.0, {8.0, 1.0, 0}},
    {"half_texture", 120.0, {0.0, 0.5, 0}},
    {"quarter_texture", 120.0, {0.0, 0.25, 0}},
    {"highlights_60", 120.0, {0.0, 1.0, 60}},
    {"highlights_200", 120.0, {0.0, 1.0, 200}},
};

std::optional<PatientModel> patient_of(std::uint64_t seed, const RunContext& context) {
  insilico::PatientOptions options;
  options.shape_seed = seed;
  options.spacing_mm = {4.0, 4.0, 4.0};  // nobody looks at this CT
  options.surface_spacing_mm = 2.5;
  auto made = insilico::make_patient(options, context);
  if (!made) return std::nullopt;
  PatientModel model;
  model.surfaces = std::move(made->surfaces);
  model.vessels = std::move(made->trees);
  model.landmarks = std::move(made->landmarks);
  return model;
}

/// What the theatre shows at a distance.
struct Scene {
  StereoRig rig;
  StereoFrame frame;
  std::vector<float> depth;
};
std::optional<Scene> scene_at(const PatientModel& patient, double distance_mm, std::uint64_t seed,
                              const RunContext& context) {
  insilico::TheatreOptions options;
  options.seed = seed;
  options.frames = 2;
  options.truth_vertices = 900;
  options.camera_distance_mm = distance_mm;
  const auto theatre = insilico::Theatre::build(patient, options, context);
  if (!theatre) return std::nullopt;
  return Scene{(*theatre)->rig(), (*theatre)->render(0), (*theatre)->depth(0)};
}

/// One byte a pixel: where the liver is.
Picture liver_mask(const Scene& scene) {
  auto bytes = std::make_shared<std::vector<std::uint8_t>>();
  for (const float z : scene.depth) bytes->push_back(z > 0.0F ? 255 : 0);
  return {scene.rig.left.width, scene.rig.left.height, 1, std::move(bytes)};
}

void add_row(const Trial& trial, const char* method, const Scene& scene, const stereo::Reconstructed& made,
             StereoProof& proof, std::string& csv) {
  const stereo::CloudErrors errors = stereo::cloud_errors(made.cloud, scene.rig.left, scene.depth);
  const std::string key = std::string("theatre_") + trial.name + "_" + method + "_";
  proof.figures[key + "points"] = made.cloud.size();
  proof.figures[key + "median_mm"] = 1e3 * errors.distance.median;
  proof.figures[key + "p95_mm"] = 1e3 * errors.distance.percentile_95;
  proof.figures[key + "bias_mm"] = 1e3 * errors.bias;
  proof.figures[key + "normalised"] = errors.normalised;
  char line[200];
  std::snprintf(line, sizeof line, "%-16s %-7s %6d %8.2f %10.3f %8.3f %9.3f %11.2f", trial.name, method,
                made.cloud.size(), made.report.density_per_cm2, 1e3 * errors.distance.median,
                1e3 * errors.distance.percentile_95, 1e3 * errors.bias, errors.normalised);
  proof.table.emplace_back(line);
  std::snprintf(line, sizeof line, "%s,%s,%d,%.4f,%.5f,%.5f,%.5f,%.4f\n", trial.name, method,
                made.cloud.size(), made.report.density_per_cm2, 1e3 * errors.distance.median,
                1e3 * errors.distance.percentile_95, 1e3 * errors.bias, errors.normalised);
  csv += line;
  double& worst = proof.figures["theatre_largest_bias_mm"];
  worst = std::max(worst, std::abs(1e3 * errors.bias));
}

/// Medians over the rows: whether sigma is right as a rule.
void add_normalised(StereoProof& proof) {
  std::vector<double> values;
  for (const auto& [key, value] : proof.figures)
    if (key.starts_with("theatre_") && key.ends_with("_normalised")) values.push_back(value);
  if (values.empty()) return;
  proof.figures["theatre_normalised_median"] = upper_median(std::move(values));
}

}  // namespace

bool prove_in_theatre(const StereoProofOptions& options, const std::filesystem::path& folder,
                      StereoProof& proof, const RunContext& context) {
  const auto patient = patient_of(options.seed, context.part(0.0, 0.15));
  if (!patient) return false;
  proof.table.emplace_back(
      "trial            method  points  per_cm2  median_mm   p95_mm   bias_mm  normalised");
  std::string csv = "trial,method,points,per_cm2,median_mm,p95_mm,bias_mm,normalised\n";
  std::optional<Scene> scene;
  double distance = 0.0, done = 0.0;
  for (const Trial& trial : kTrials) {
    if (context.cancelled()) return false;
    if (std::string_view(trial.name).find(options.only) == std::string_view::npos) continue;
    context.progress(0.15 + 0.85 * done++ / static_cast<double>(std::size(kTrials)), "prove.theatre");
    if (!scene || distance != trial.distance_mm)
      scene = scene_at(*patient, distance = trial.distance_mm, options.seed, context.quiet());
    if (!scene) return false;
    const Picture left = hardened(scene->frame.left, trial.hardship, 2 * options.seed + 11);
    const Picture right = hardened(scene->frame.right, trial.hardship, 2 * options.seed + 12);
    for (const auto& [name, method] :
         {std::pair<const char*, stereo::Method>{"sparse", stereo::Method::sparse},
          {"dense", stereo::Method::dense}}) {
      stereo::ReconstructOptions reconstruction;
      reconstruction.method = method;
      const auto made = stereo::reconstruct_pair({{left, right}, scene->rig, liver_mask(*scene), {}},
                                                 reconstruction, context.quiet());
      if (!made) return false;
      add_row(trial, name, *scene, *made->whole, proof, csv);
    }
  }
  add_normalised(proof);
  write_file_atomically(folder / "theatre.csv", csv);
  return true;
}

}  // namespace glisson::experiments
