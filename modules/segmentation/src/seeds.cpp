// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <nlohmann/json.hpp>

#include "glisson/core/error.h"
#include "glisson/core/json_file.h"
#include "glisson/core/patient_range.h"
#include "glisson/segmentation/segment.h"

namespace glisson::segmentation {
namespace {

constexpr const char* kRemedy = "Write lists of [x, y, z] in mm, patient coordinates (LPS)";

Points points_from(const std::string& file, const std::string& field, const nlohmann::json& list) {
  if (!list.is_array()) throw InputError(file, field, "is not a list of points", kRemedy);
  Points points(static_cast<Eigen::Index>(list.size()), 3);
  for (std::size_t n = 0; n < list.size(); ++n) {
    const nlohmann::json& point = list[n];
    const bool good = point.is_array() && point.size() == 3 && point[0].is_number() && point[1].is_number() &&
                      point[2].is_number();
    if (!good) throw InputError(file, field + " " + std::to_string(n + 1), "is not a point", kRemedy);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double mm = point[axis];
      if (!std::isfinite(mm) || std::abs(mm) > 1e3 * kPatientRange)
        throw InputError(file, field + " " + std::to_string(n + 1), "is nowhere near a patient", kRemedy);
      points(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(axis)) = 1e-3 * mm;
    }
  }
  return points;
}

nlohmann::json list_of(const Points& points) {
  nlohmann::json list = nlohmann::json::array();
  for (Eigen::Index n = 0; n < points.rows(); ++n)
    list.push_back({1e3 * points(n, 0), 1e3 * points(n, 1), 1e3 * points(n, 2)});
  return list;
}

constexpr const char* kDiameters = "lesion_diameters_mm";

std::string diameter_field(std::size_t lesion) {
  std::string field = kDiameters;
  field += ' ';
  return field += std::to_string(lesion + 1);
}

std::vector<double> diameters_from(const std::string& file, const nlohmann::json& list) {
  const char* remedy = "Write one number for each lesion, in mm; 0 where it is not known";
  if (!list.is_array()) throw InputError(file, kDiameters, "is not a list of numbers", remedy);
  std::vector<double> diameters;
  for (const nlohmann::json& one : list) {
    if (!one.is_number()) throw InputError(file, diameter_field(diameters.size()), "is not a number", remedy);
    diameters.push_back(one);
  }
  return diameters;
}

}  // namespace

void check_diameters(const std::string& file, const Seeds& seeds) {
  for (std::size_t n = 0; n < seeds.lesion_diameters_mm.size(); ++n) {
    const double mm = seeds.lesion_diameters_mm[n];
    if (mm == 0.0) continue;
    const std::string field = diameter_field(n);
    if (!(mm >= Seeds::kLeastDiameter && mm <= Seeds::kMostDiameter))
      throw InputError(file, field, "is no lesion's", "Write 3 to 250 mm, or 0 where it is not known");
    if (n >= seeds.lesions.size() || seeds.lesions[n].rows() == 0)
      throw InputError(file, field, "belongs to a lesion without a point",
                       "Write the point of this lesion, too, or 0");
  }
}

Seeds read_seeds(const std::filesystem::path& path) {
  const nlohmann::json document = read_json(path);
  const std::string file = path.string();
  if (!document.is_object())
    throw InputError(file, "", "is not a JSON object of seeds", R"(Write {"liver": [[x, y, z], ...], ...})");
  Seeds seeds;
  for (const auto& [key, value] : document.items()) {
    if (key == "liver")
      seeds.liver = points_from(file, key, value);
    else if (key == "portal_vein")
      seeds.portal_vein = points_from(file, key, value);
    else if (key == "hepatic_veins")
      seeds.hepatic_veins = points_from(file, key, value);
    else if (key == "vena_cava")
      seeds.vena_cava = points_from(file, key, value);
    else if (key == "gallbladder")
      seeds.gallbladder = points_from(file, key, value);
    else if (key == "background")
      seeds.background = points_from(file, key, value);
    else if (key == kDiameters)
      seeds.lesion_diameters_mm = diameters_from(file, value);
    else if (key == "lesions") {
      if (!value.is_array()) throw InputError(file, key, "is not a list of lesions", kRemedy);
      for (std::size_t n = 0; n < value.size(); ++n)
        seeds.lesions.push_back(points_from(file, "lesions " + std::to_string(n + 1), value[n]));
    } else {
      throw InputError(
          file, key, "is no structure that seeds are read for",
          "Use liver, portal_vein, hepatic_veins, vena_cava, gallbladder, lesions, lesion_diameters_mm or "
          "background");
    }
  }
  check_diameters(file, seeds);
  return seeds;
}

void write_seeds(const std::filesystem::path& path, const Seeds& seeds) {
  nlohmann::json document = {{"liver", list_of(seeds.liver)},
                             {"portal_vein", list_of(seeds.portal_vein)},
                             {"hepatic_veins", list_of(seeds.hepatic_veins)},
                             {"vena_cava", list_of(seeds.vena_cava)},
                             {"gallbladder", list_of(seeds.gallbladder)},
                             {"background", list_of(seeds.background)},
                             {"lesions", nlohmann::json::array()}};
  for (const Points& lesion : seeds.lesions) document["lesions"].push_back(list_of(lesion));
  if (!seeds.lesion_diameters_mm.empty()) document[kDiameters] = seeds.lesion_diameters_mm;
  write_json(path, document);
}

}  // namespace glisson::segmentation
