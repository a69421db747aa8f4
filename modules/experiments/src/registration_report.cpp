// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/experiments/registration_report.h"

#include <array>
#include <string_view>
#include <utility>

#include "glisson/registration/refusal.h"
#include "report.h"

namespace glisson::experiments {
namespace {

using Rows = std::vector<std::pair<std::string, std::string>>;

/// "lesion_2" -> "Lesion 2".
std::string spoken(std::string name) {
  for (char& letter : name)
    if (letter == '_') letter = ' ';
  if (!name.empty() && name[0] >= 'a' && name[0] <= 'z') name[0] = static_cast<char>(name[0] - 'a' + 'A');
  return name;
}

/// Of each place in the organ of which something is expected.
Rows places(const Figures& figures) {
  constexpr std::string_view kExpected = "_expected_error_mm";
  Rows rows;
  for (const auto& [key, value] : figures) {
    if (!key.ends_with(kExpected)) continue;
    const std::string name = key.substr(0, key.size() - kExpected.size());
    rows.emplace_back(key, spoken(name) + ": expected error, mean");
    for (const char* k : {"1", "2", "3"})
      rows.emplace_back(
          name + "_half_axis_95_" + k + "_mm",
          spoken(name) + ": half axis " + k + " of the ellipsoid that holds it in 95 of 100 cases");
    rows.emplace_back(name + "_expected_error_after_look_mm",
                      spoken(name) + ": expected error once the best look has been taken");
  }
  return rows;
}

Rows rivals(const Figures& figures) {
  Rows rows;
  for (int k = 1; figures.contains("rival_" + std::to_string(k) + "_probability"); ++k) {
    const std::string name = "rival_" + std::to_string(k);
    rows.emplace_back(name + "_probability", "Other place " + std::to_string(k) + ": probability");
    rows.emplace_back(name + "_away_mm", "Other place " + std::to_string(k) + ": mean distance of the nodes");
  }
  return rows;
}

std::vector<ReportTable> tables(const Figures& figures) {
  return {
      {"The registration",
       "The residual is no accuracy: the points agree with the model because they moved it.",
       {{"registration_seen_share", "Share of the organ's surface that the points show"},
        {"rigid_residual_mm", "Distance of the points after the rigid start"},
        {"displacement_mean_mm", "Deformation, mean of the nodes"},
        {"displacement_max_mm", "Deformation, maximum"},
        {"registration_residual_mm", "Residual of the points to the surface"},
        {"registration_steps", "Steps"},
        {"registration_plateaus", "Plateaus"},
        {"operations_simulated", "Simulated operations that it rests on"},
        {"forces_active", "Places where forces act"},
        {"forces_poisson_ratio", "Poisson's ratio of the most probable law"}}},
      {"Expected error",
       "What the registration expects of its own error, if it expects it rightly.",
       {{"expected_error_mean_mm", "Organ, mean of the nodes"}, {"expected_error_max_mm", "Organ, maximum"}}},
      {"Expected error of lesions and vessel forks", "", places(figures)},
      {"Other places where the organ may be", "", rivals(figures)},
      {"What speaks for and against it",
       "",
       {{"evidence_cloud_noise_mm", "Noise of the points"},
        {"evidence_misfit_mm", "Distance of whole places from the most probable shape"},
        {"evidence_held_out_mm", "The same, each place predicted from all others"},
        {"evidence_strangeness", "Strangeness of the shape (about 1: as in simulated operations)"},
        {"evidence_margin_off_mm", "Marked margin from the model's"},
        {"evidence_notch_off_mm", "Marked notch from the model's"},
        {"evidence_hidden_share", "Points that the model would hide"},
        {"evidence_turned_share", "Points that face another way than the model"},
        {"evidence_mirror_odds_ln", "Logarithm of the odds against the mirror image"},
        {"evidence_elsewhere_probability", "Probability of more than 20 mm elsewhere"},
        {"evidence_size", "Share by which the organ would have to be larger"},
        {"evidence_volume_change", "Change of its volume since the CT, as a share"}}},
      {"Errors against the truth that was given",
       "",
       {{"tre_volume_mean_mm", "All nodes, mean"},
        {"tre_volume_max_mm", "All nodes, maximum"},
        {"tre_surface_mean_mm", "Surface, mean"},
        {"tre_target_mean_mm", "Lesions' centres, mean"}}}};
}

}  // namespace

void write_registration_report(const std::filesystem::path& path, const std::string& subject,
                               const Figures& figures, const std::string& ending,
                               const std::vector<std::string>& doubts) {
  const std::string introduction =
      ending == registration::kRefused
          ? "Refused: what is known contradicts that the organ lies where this registration has put it."
          : "Where the organ lies before the camera, and how far off that may be. The computation ended: " +
                spoken(ending) + ".";
  write_report(path, "Registration: " + subject, introduction, tables(figures), {}, figures, doubts);
}

}  // namespace glisson::experiments
