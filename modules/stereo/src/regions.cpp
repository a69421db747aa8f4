// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/stereo/regions.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "glisson/core/error.h"
#include "glisson/core/json_file.h"

namespace glisson::stereo {
namespace {

constexpr const char* kRemedy =
    "Expected {\"image\": \"left\", \"frame\": 0, \"regions\": [{\"label\": \"surface\", \"polygon\": [[x, "
    "y], "
    "...]}]}";

const char* feature_code(Feature feature) {
  switch (feature) {
    case Feature::surface:
      return "surface";
    case Feature::anterior_margin:
      return "anterior_margin";
    case Feature::umbilical_notch:
      return "umbilical_notch";
  }
  return "surface";
}

std::optional<Feature> feature_of(const std::string& code) {
  for (const Feature feature : {Feature::surface, Feature::anterior_margin, Feature::umbilical_notch})
    if (code == feature_code(feature)) return feature;
  return std::nullopt;
}

Region parse_region(const std::string& file, const std::string& field, const nlohmann::json& entry) {
  if (!entry.is_object() || !entry.contains("label") || !entry["label"].is_string())
    throw InputError(file, field, "has no label", kRemedy);
  const auto label = entry["label"].get<std::string>();
  const auto feature = feature_of(label);
  if (!feature)
    throw InputError(file, field, "has the label \"" + label.substr(0, 40) + "\", which is none",
                     "Labels are surface, anterior_margin and umbilical_notch");
  Region region;
  region.feature = *feature;
  if (!entry.contains("polygon") || !entry["polygon"].is_array())
    throw InputError(file, field, "has no polygon", kRemedy);
  for (const nlohmann::json& point : entry["polygon"]) {
    if (!point.is_array() || point.size() != 2 || !point[0].is_number() || !point[1].is_number())
      throw InputError(file, field, "has a vertex that is not [x, y]", kRemedy);
    region.polygon.emplace_back(point[0].get<double>(), point[1].get<double>());
    if (!region.polygon.back().allFinite())
      throw InputError(file, field, "has a vertex that is not finite", kRemedy);
  }
  if (region.polygon.size() < 3)
    throw InputError(file, field,
                     "has " + std::to_string(region.polygon.size()) + " vertices, which enclose nothing",
                     "Click three or more");
  return region;
}

bool inside(const std::vector<Eigen::Vector2d>& polygon, const Eigen::Vector2d& p) {
  bool in = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Eigen::Vector2d &a = polygon[i], &b = polygon[j];
    if ((a.y() > p.y()) != (b.y() > p.y()) &&
        p.x() < (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()) + a.x())
      in = !in;
  }
  return in;
}

}  // namespace

std::optional<Feature> feature_at(const Regions& regions, const Eigen::Vector2d& pixel) {
  std::optional<Feature> found;
  for (const Region& region : regions.regions)
    if ((!found || region.feature > *found) && inside(region.polygon, pixel)) found = region.feature;
  return found;
}

Regions read_regions(const std::filesystem::path& path) {
  const nlohmann::json document = read_json(path);
  const std::string file = path.string();
  if (!document.is_object() || !document.contains("regions") || !document["regions"].is_array())
    throw InputError(file, "regions", "is missing", kRemedy);
  if (document.contains("image") && document["image"] != "left")
    throw InputError(file, "image", "is not the left one", "Click the regions on the left image");
  Regions regions;
  if (document.contains("frame")) {
    const nlohmann::json& frame = document["frame"];
    if (!frame.is_number_integer() || frame.get<std::int64_t>() < 0 ||
        frame.get<std::int64_t>() > 1'000'000'000)
      throw InputError(file, "frame", "is not the number of a frame", kRemedy);
    regions.frame = frame.get<int>();
  }
  int i = 0;
  for (const nlohmann::json& entry : document["regions"])
    regions.regions.push_back(parse_region(file, "region " + std::to_string(i++), entry));
  return regions;
}

void write_regions(const std::filesystem::path& path, const Regions& regions) {
  nlohmann::json document = {
      {"image", "left"}, {"frame", regions.frame}, {"regions", nlohmann::json::array()}};
  for (const Region& region : regions.regions) {
    require(region.polygon.size() >= 3, "a region has three vertices or more");
    nlohmann::json polygon = nlohmann::json::array();
    for (const Eigen::Vector2d& p : region.polygon) {
      require(p.allFinite(), "the vertices of a region are finite");
      polygon.push_back({p.x(), p.y()});
    }
    document["regions"].push_back({{"label", feature_code(region.feature)}, {"polygon", polygon}});
  }
  write_json(path, document);
}

}  // namespace glisson::stereo
