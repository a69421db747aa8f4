// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/fem/loads_io.h"

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>

#include "glisson/core/error.h"
#include "glisson/core/json_file.h"
#include "glisson/core/json_text.h"

namespace glisson::fem {
namespace {

using nlohmann::json;

constexpr double kGravity = 9.81;
// What no load of a patient's organ goes beyond: a larger number is a slip, and its result would be nonsense.
constexpr double kMostForce = 1e4;      // N
constexpr double kMostGravity = 100.0;  // m/s2
constexpr double kMostPlace = 1e4;      // mm
constexpr double kMostStiffness = 1e9;  // N/m
constexpr double kMostSeconds = 3600.0;
constexpr const char* kTooLarge = "is larger than a load can be";

/// Reads one JSON object and says where it stands in the file when something is wrong.
class Reader {
 public:
  Reader(const json& value, std::string file, std::string path, const std::set<std::string>& keys)
      : value_(value), file_(std::move(file)), path_(std::move(path)) {
    if (!value_.is_object()) fail("", "is not an object", "Write {...} there");
    std::string known;
    for (const std::string& key : keys) known += (known.empty() ? "" : ", ") + key;
    for (const auto& [key, unused] : value_.items())
      if (!keys.contains(key)) fail(key, "is not a key of a load file", "Take one of " + known);
  }

  bool has(const std::string& key) const { return value_.contains(key); }
  const json& at(const std::string& key) const { return value_.at(key); }
  std::string field(const std::string& key) const {
    return path_.empty() ? key : key.empty() ? path_ : path_ + "." + key;
  }
  const std::string& file() const { return file_; }

  [[noreturn]] void fail(const std::string& key, const std::string& problem,
                         const std::string& remedy) const {
    throw InputError(file_, field(key), problem, remedy);
  }

  double number(const std::string& key) const {
    if (!has(key)) fail(key, "is missing", "Add it");
    if (!at(key).is_number() || !std::isfinite(at(key).get<double>()))
      fail(key, "is not a number", "Write a finite number");
    return at(key).get<double>();
  }
  double positive(const std::string& key) const {
    const double value = number(key);
    if (!(value > 0.0)) fail(key, "is " + at(key).dump(), "Give a number above 0");
    return value;
  }
  /// @param most of each number's size; @param remedy for one beyond.
  Eigen::Vector3d vector(const std::string& key, double most, const char* remedy) const {
    if (!has(key)) fail(key, "is missing", "Add it");
    const json& list = at(key);
    if (!list.is_array() || list.size() != 3) fail(key, "is not three numbers", "Write [x, y, z]");
    Eigen::Vector3d v;
    for (std::size_t k = 0; k < 3; ++k) {
      if (!list[k].is_number() || !std::isfinite(list[k].get<double>()))
        fail(key, "is not three finite numbers", "Write [x, y, z]");
      v[static_cast<Eigen::Index>(k)] = list[k].get<double>();
    }
    if (v.cwiseAbs().maxCoeff() > most) fail(key, kTooLarge, remedy);
    return v;
  }
  /// In metres.
  Eigen::Vector3d point(const std::string& key) const {
    return 1e-3 * vector(key, kMostPlace, "Give millimetres, at most 10000");
  }
  /// In m/s2.
  Eigen::Vector3d acceleration(const std::string& key) const {
    return vector(key, kMostGravity, "Give at most 100 m/s2");
  }
  std::vector<int> indices(const std::string& key) const {
    if (!at(key).is_array()) fail(key, "is not a list", "Write [0, 1, ...]");
    std::vector<int> list;
    for (const json& item : at(key)) list.push_back(index(item, key));
    return list;
  }
  int index(const json& item, const std::string& key) const {
    if (!item.is_number_integer() || item.get<long long>() < 0 || item.get<long long>() > 1'000'000'000)
      fail(key, "holds " + item.dump() + ", which is no index", "Give 0-based indices");
    return item.get<int>();
  }

 private:
  const json& value_;
  std::string file_, path_;
};

LoadRegion read_region(const Reader& parent, bool with_normal) {
  std::set<std::string> keys{"centre_mm", "radius_mm", "low_mm", "high_mm"};
  if (with_normal) keys.insert({"normal", "angle_deg"});
  const Reader r(parent.at("region"), parent.file(), parent.field("region"), keys);
  LoadRegion region;
  if (r.has("centre_mm") || r.has("radius_mm")) {
    region.centre = r.point("centre_mm");
    region.radius = 1e-3 * r.positive("radius_mm");
  }
  if (r.has("low_mm") || r.has("high_mm")) {
    region.low = r.point("low_mm");
    region.high = r.point("high_mm");
    if ((*region.low - *region.high).maxCoeff() > 0.0)
      r.fail("low_mm", "lies above high_mm", "Swap the coordinates");
  }
  if (r.has("normal") || r.has("angle_deg")) {
    const Eigen::Vector3d normal = r.vector("normal", 1e6, "Give a direction");
    if (normal.norm() < 1e-12) r.fail("normal", "is zero", "Give a direction");
    region.normal = normal.normalized();
    const double degrees = r.positive("angle_deg");
    if (degrees > 180.0) r.fail("angle_deg", "is above 180", "Give at most 180 degrees: every direction");
    region.angle = degrees * std::numbers::pi / 180.0;
  }
  if (!region.centre && !region.low && !region.normal)
    r.fail("", "names no ball, box or direction", "Give centre_mm and radius_mm, or low_mm and high_mm");
  return region;
}

LoadPlace read_place(const Reader& r) {
  LoadPlace place;
  const int given = int{r.has("node")} + int{r.has("point_mm")} + int{r.has("region")};
  if (given != 1)
    r.fail("", given == 0 ? "has no place" : "has several places", "Give one of node, point_mm, region");
  if (r.has("node")) {
    place.node = r.index(r.at("node"), "node");
  } else if (r.has("point_mm")) {
    place.point = r.point("point_mm");
  } else {
    place.region = read_region(r, false);
  }
  return place;
}

Eigen::Vector3d read_posture(const Reader& r, const std::string& key) {
  if (!r.at(key).is_string()) return r.acceleration(key);
  try {
    return gravity_in_posture(r.at(key).get<std::string>());
  } catch (const InputError& error) {
    r.fail(key, error.problem(), error.remedy());
  }
}

void read_gravity(const Reader& root, LoadCase& load) {
  const Reader r(root.at("gravity"), root.file(), "gravity", {"change", "from", "to"});
  if (r.has("change")) {
    if (r.has("from") || r.has("to")) r.fail("change", "stands beside from or to", "Give one or the other");
    load.gravity_change = r.acceleration("change");
    return;
  }
  if (!r.has("to")) r.fail("to", "is missing", "Give change, or to (and from)");
  load.gravity_change =
      read_posture(r, "to") - (r.has("from") ? read_posture(r, "from") : gravity_in_posture("supine"));
}

void read_pressure(const Reader& root, LoadCase& load) {
  const Reader r(root.at("pressure"), root.file(), "pressure", {"pascal", "triangles", "region"});
  load.pressure = r.number("pascal");
  if (std::abs(load.pressure) > 1e5)
    r.fail("pascal", "is " + r.at("pascal").dump() + " Pa", "Give at most 1e5 Pa (12 mmHg are 1600 Pa)");
  if (r.has("triangles")) {
    load.pressure_triangles = r.indices("triangles");
    if (load.pressure_triangles.empty()) r.fail("triangles", "is empty", "Leave it out to press everywhere");
  }
  if (r.has("region")) load.pressure_region = read_region(r, true);
}

/// N/m.
double stated_stiffness(const Reader& r) {
  if (r.has("newton_per_metre") == r.has("structure"))
    r.fail("newton_per_metre", r.has("structure") ? "stands beside structure" : "is missing",
           "Give newton_per_metre or structure");
  if (r.has("newton_per_metre")) return r.positive("newton_per_metre");
  const Reader s(r.at("structure"), r.file(), r.field("structure"), {"pascal", "area_mm2", "length_mm"});
  return s.positive("pascal") * s.positive("area_mm2") * 1e-6 / (s.positive("length_mm") * 1e-3);
}

double read_stiffness(const Reader& r) {
  const double stiffness = stated_stiffness(r);
  if (stiffness > kMostStiffness)
    r.fail(r.has("structure") ? "structure" : "newton_per_metre", kTooLarge, "Give at most 1e9 N/m");
  return stiffness;
}

const json& list_of(const Reader& root, const std::string& key) {
  if (!root.at(key).is_array()) root.fail(key, "is not a list", "Write [{...}, ...]");
  return root.at(key);
}

LoadCase parse(const json& document, const std::string& name) {
  const Reader root(document, name, "",
                    {"gravity", "pressure", "forces", "springs", "fixed", "moved", "ramp_s", "comment"});
  LoadCase load;
  if (root.has("gravity")) read_gravity(root, load);
  if (root.has("pressure")) read_pressure(root, load);
  if (root.has("forces"))
    for (const json& item : list_of(root, "forces")) {
      const std::string path = "forces[" + std::to_string(load.forces.size()) + "]";
      const Reader r(item, name, path, {"node", "point_mm", "region", "newton"});
      load.forces.push_back({read_place(r), r.vector("newton", kMostForce, "Give at most 10000 N")});
    }
  if (root.has("springs"))
    for (const json& item : list_of(root, "springs")) {
      const std::string path = "springs[" + std::to_string(load.springs.size()) + "]";
      const Reader r(item, name, path,
                     {"node", "point_mm", "region", "newton_per_metre", "structure", "target_mm"});
      LoadSpring spring{read_place(r), read_stiffness(r), {}};
      if (r.has("target_mm")) {
        if (spring.place.region)
          r.fail("target_mm", "stands beside a region", "Give a node or a point, or leave the target out");
        spring.target = r.point("target_mm");
      }
      load.springs.push_back(spring);
    }
  if (root.has("fixed")) {
    const Reader r(root.at("fixed"), name, "fixed", {"nodes", "region"});
    if (r.has("nodes")) load.fixed_nodes = r.indices("nodes");
    if (r.has("region")) load.fixed_region = read_region(r, false);
  }
  if (root.has("moved"))
    for (const json& item : list_of(root, "moved")) {
      const Reader r(item, name, "moved[" + std::to_string(load.moved.size()) + "]",
                     {"nodes", "region", "by_mm"});
      LoadMove move;
      if (r.has("nodes")) move.nodes = r.indices("nodes");
      if (r.has("region")) move.region = read_region(r, false);
      if (move.nodes.empty() && !move.region) r.fail("", "names no nodes", "Give nodes or a region");
      move.by = r.point("by_mm");
      load.moved.push_back(std::move(move));
    }
  if (root.has("ramp_s")) {
    load.ramp = root.number("ramp_s");
    if (load.ramp < 0.0) root.fail("ramp_s", "is negative", "Give seconds, 0 or more");
    if (load.ramp > kMostSeconds) root.fail("ramp_s", kTooLarge, "Give seconds, at most 3600");
  }
  if (!root.has("gravity") && !root.has("pressure") && load.forces.empty() && load.springs.empty() &&
      load.moved.empty())
    root.fail("", "holds no load", "Give gravity, pressure, forces, springs or moved");
  return load;
}

}  // namespace

Eigen::Vector3d gravity_in_posture(const std::string& posture) {
  // LPS: x to the patient's left, y to the back, z to the head.
  static const std::map<std::string, Eigen::Vector3d> kPostures{
      {"supine", {0.0, kGravity, 0.0}},     {"prone", {0.0, -kGravity, 0.0}},
      {"left_flank", {kGravity, 0.0, 0.0}}, {"right_flank", {-kGravity, 0.0, 0.0}},
      {"standing", {0.0, 0.0, -kGravity}},  {"none", {0.0, 0.0, 0.0}}};
  const auto found = kPostures.find(posture);
  if (found == kPostures.end())
    throw InputError("gravity", posture, "is \"" + posture + "\", which is not a posture",
                     "Take supine, prone, left_flank, right_flank, standing, none or three numbers in m/s2");
  return found->second;
}

LoadCase read_load_case(const std::filesystem::path& path) { return parse(read_json(path), path.string()); }

LoadCase parse_load_case(const std::string& text, const std::string& name) {
  json document;
  try {
    document = parse_json(text, name);
  } catch (const json::exception&) {
    throw InputError(name, "", "is not valid JSON", "Correct it");
  }
  return parse(document, name);
}

}  // namespace glisson::fem
