// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/stereo/regions.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <nlohmann/json.hpp>

#include "glisson/core/error.h"
#include "glisson/core/json_file.h"

namespace glisson::stereo {
namespace {

constexpr const char* kRemedy =
    "Expected {\"image\": \"left\", \"frame\": 0, \"regions\": [{\"label\": \"surface\", \"polygon\": [[x, "
    "y], "
    "...]}]}";

constexpr double kFarthest = 1e5;  // pixels

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

[[noreturn]] void refuse(const std::string& file, const std::string& field, const std::string& problem,
                         const char* remedy = kRemedy) {
  throw InputError(file, field, problem, remedy);
}

Side parse_side(const std::string& file, const std::string& field, const nlohmann::json& value) {
  if (value == "left") return Side::left;
  if (value == "right") return Side::right;
  refuse(file, field, "is on no picture of a stereo laparoscope", "Write \"left\" or \"right\" as its image");
}

std::vector<Eigen::Vector2d> parse_vertices(const std::string& file, const std::string& field,
                                            const nlohmann::json& points) {
  std::vector<Eigen::Vector2d> vertices;
  for (const nlohmann::json& point : points) {
    if (!point.is_array() || point.size() != 2 || !point[0].is_number() || !point[1].is_number())
      refuse(file, field, "has a vertex that is not [x, y]");
    vertices.emplace_back(point[0].get<double>(), point[1].get<double>());
    if (!vertices.back().allFinite()) refuse(file, field, "has a vertex that is not finite");
    if (vertices.back().cwiseAbs().maxCoeff() > kFarthest)
      refuse(file, field, "has a vertex that lies far outside any picture");
  }
  return vertices;
}

Region parse_region(const std::string& file, const std::string& field, const nlohmann::json& entry) {
  if (!entry.is_object() || !entry.contains("label") || !entry["label"].is_string())
    refuse(file, field, "has no label");
  const auto label = entry["label"].get<std::string>();
  const auto feature = feature_of(label);
  if (!feature)
    refuse(file, field, "has the label \"" + label.substr(0, 40) + "\", which is none",
           "Labels are surface, anterior_margin and umbilical_notch");
  Region region;
  region.feature = *feature;
  if (entry.contains("image")) region.side = parse_side(file, field, entry["image"]);
  region.closed = !entry.contains("curve");
  const char* const shape = region.closed ? "polygon" : "curve";
  if (!entry.contains(shape) || !entry[shape].is_array())
    refuse(file, field, "has no polygon, and no curve that is a list");
  region.polygon = parse_vertices(file, field, entry[shape]);
  if (region.polygon.size() < region.fewest_vertices())
    refuse(file, field,
           "has " + std::to_string(region.polygon.size()) +
               (region.closed ? " vertices, which enclose nothing" : " vertices, which are no line"),
           region.closed ? "Click three or more" : "Click two or more");
  if (!region.closed && entry.contains("half_width_px")) {
    const nlohmann::json& width = entry["half_width_px"];
    if (!width.is_number() || !(width.get<double>() > 0.0 && width.get<double>() <= kFarthest))
      refuse(file, field, "has a width that is not a positive number of pixels");
    region.half_width_px = width.get<double>();
  }
  return region;
}

std::string parse_identity(const std::string& file, const nlohmann::json& document) {
  if (!document.contains("identity")) return {};
  const nlohmann::json& identity = document["identity"];
  const std::string text = identity.is_string() ? identity.get<std::string>() : std::string();
  if (text.size() != 16 || text.find_first_not_of("0123456789abcdef") != std::string::npos)
    refuse(file, "identity", "is not one that a frame has (16 hexadecimal digits)",
           "Take it out, or click the regions again");
  return text;
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

std::uint64_t mixed(std::uint64_t hash, std::uint64_t word) {
  hash = (hash ^ word) * 0x9E3779B97F4A7C15ULL;
  return hash ^ (hash >> 32);
}

std::uint64_t mixed(std::uint64_t hash, const Picture& picture) {
  for (const int side : {picture.width, picture.height, picture.channels})
    hash = mixed(hash, static_cast<std::uint64_t>(side));
  if (picture.empty()) return hash;
  const std::vector<std::uint8_t>& bytes = *picture.bytes;
  std::size_t i = 0;
  for (; i + 8 <= bytes.size(); i += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data() + i, 8);
    hash = mixed(hash, word);
  }
  for (; i < bytes.size(); ++i) hash = mixed(hash, bytes[i]);
  return hash;
}

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Whether the insides of ab and cd meet in one point.
bool cross_each_other(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
                      const Eigen::Vector2d& d) {
  const auto side = [](const Eigen::Vector2d& p, const Eigen::Vector2d& q, const Eigen::Vector2d& r) {
    return cross(q - p, r - p);
  };
  return side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0;
}

std::size_t edges_of(const Region& region) {
  return region.closed ? region.polygon.size() : region.polygon.size() - 1;
}

}  // namespace

std::string frame_identity(const Picture& left, const Picture& right) {
  char text[17];
  std::snprintf(text, sizeof text, "%016llx",
                static_cast<unsigned long long>(mixed(mixed(0x243F6A8885A308D3ULL, left), right)));
  return text;
}

void require_regions_of(const Regions& regions, const Picture& left, const Picture& right) {
  if (regions.identity.empty() || regions.regions.empty()) return;
  const std::string identity = frame_identity(left, right);
  if (identity == regions.identity) return;
  throw InputError("regions", "identity",
                   "belong to frame " + std::to_string(regions.frame) + " (" + regions.identity +
                       "), not to this pair (" + identity + ")",
                   "Load the pair that they were clicked on, or click them again on this one");
}

OutlinePlace closest_on_outline(const Region& region, const Eigen::Vector2d& pixel) {
  require(!region.polygon.empty(), "an outline has a vertex or more");
  OutlinePlace best{0, region.polygon[0], (region.polygon[0] - pixel).norm()};
  for (std::size_t i = 0; i < edges_of(region); ++i) {
    const Eigen::Vector2d &a = region.polygon[i], &b = region.polygon[(i + 1) % region.polygon.size()];
    const double length = (b - a).squaredNorm();
    const double t = length > 0.0 ? std::clamp((pixel - a).dot(b - a) / length, 0.0, 1.0) : 0.0;
    const Eigen::Vector2d place = a + t * (b - a);
    const double distance = (place - pixel).norm();
    if (distance < best.distance_px) best = {i, place, distance};
  }
  return best;
}

bool crosses_itself(const Region& region) {
  if (region.polygon.size() < 4) return false;
  const std::size_t n = region.polygon.size(), edges = edges_of(region);
  for (std::size_t i = 0; i < edges; ++i)
    for (std::size_t j = i + 2; j < edges; ++j)
      if (cross_each_other(region.polygon[i], region.polygon[i + 1], region.polygon[j],
                           region.polygon[(j + 1) % n]))
        return true;
  return false;
}

bool contains(const Region& region, const Eigen::Vector2d& pixel) {
  if (region.polygon.size() < region.fewest_vertices()) return false;
  return region.closed ? inside(region.polygon, pixel)
                       : closest_on_outline(region, pixel).distance_px <= region.half_width_px;
}

std::optional<Feature> feature_at(const Regions& regions, Side side, const Eigen::Vector2d& pixel) {
  std::optional<Feature> found;
  for (const Region& region : regions.regions)
    if (region.side == side && (!found || region.feature > *found) && contains(region, pixel))
      found = region.feature;
  return found;
}

std::optional<Feature> feature_at(const Regions& regions, const Eigen::Vector2d& pixel) {
  return feature_at(regions, Side::left, pixel);
}

Regions read_regions(const std::filesystem::path& path) {
  const nlohmann::json document = read_json(path);
  const std::string file = path.string();
  if (!document.is_object() || !document.contains("regions") || !document["regions"].is_array())
    throw InputError(file, "regions", "is missing", kRemedy);
  if (document.contains("image") && document["image"] != "left")
    throw InputError(file, "image", "is not the left one",
                     "Write \"left\" here, and \"right\" as the image of each region of the right one");
  Regions regions;
  regions.identity = parse_identity(file, document);
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
  if (!regions.identity.empty()) document["identity"] = regions.identity;
  for (const Region& region : regions.regions) {
    require(region.polygon.size() >= region.fewest_vertices(),
            "a region has three vertices or more, a curve two");
    nlohmann::json vertices = nlohmann::json::array();
    for (const Eigen::Vector2d& p : region.polygon) {
      require(p.allFinite(), "the vertices of a region are finite");
      vertices.push_back({p.x(), p.y()});
    }
    nlohmann::json entry = {{"label", feature_code(region.feature)},
                            {region.closed ? "polygon" : "curve", vertices}};
    if (!region.closed) {
      require(std::isfinite(region.half_width_px) && region.half_width_px > 0.0, "a curve has a width");
      entry["half_width_px"] = region.half_width_px;
    }
    if (region.side == Side::right) entry["image"] = "right";
    document["regions"].push_back(std::move(entry));
  }
  write_json(path, document);
}

}  // namespace glisson::stereo
