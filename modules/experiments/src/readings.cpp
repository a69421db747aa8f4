// SPDX-License-Identifier: GPL-3.0-or-later
#include "readings.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "glisson/core/error.h"

namespace glisson::experiments {
namespace {
namespace fs = std::filesystem;
using atlas::Structure;
using nlohmann::json;

constexpr double kMillimetre = 1e-3;
constexpr const char* kRemedy = "Write it as [x, y, z] in millimetres (LPS)";

/// One place of a liver in the file.
class Entry {
 public:
  Entry(const json& entry, std::string file, std::string liver)
      : entry_(entry), file_(std::move(file)), liver_(std::move(liver)) {
    if (!entry.is_object()) throw InputError(file_, liver_, "is no reading", kRemedy);
  }

  /// None: it is not there, or null.
  Points point(const char* field) const {
    if (!entry_.contains(field) || entry_[field].is_null()) return Points(0, 3);
    Points one(1, 3);
    one.row(0) = triple(entry_[field], field);
    return one;
  }

  Points line(const char* field) const {
    if (!entry_.contains(field) || !entry_[field].is_array() || entry_[field].size() < 2) refuse(field);
    Points points(static_cast<Eigen::Index>(entry_[field].size()), 3);
    Eigen::Index row = 0;
    for (const json& one : entry_[field]) points.row(row++) = triple(one, field);
    return points;
  }

  [[noreturn]] void refuse(const char* field) const {
    throw InputError(file_, liver_ + "." + field, "is no place", kRemedy);
  }

 private:
  Eigen::RowVector3d triple(const json& value, const char* field) const {
    if (!value.is_array() || value.size() != 3) refuse(field);
    Eigen::RowVector3d point;
    for (std::size_t k = 0; k < 3; ++k) {
      if (!value[k].is_number()) refuse(field);
      point[static_cast<Eigen::Index>(k)] = kMillimetre * value[k].get<double>();
    }
    return point;
  }

  const json& entry_;
  std::string file_, liver_;
};

Reading reading_of(const Entry& entry) {
  Reading reading{entry.point("notch"), entry.point("notch_again"), entry.line("falciform"),
                  entry.line("anterior_margin"), entry.point("umbilical_tip")};
  if (reading.notch.rows() == 0) entry.refuse("notch");
  return reading;
}

/// A line's points as the atlas orders them.
Points ordered(Structure structure, const Points& line, const Points& notch) {
  return atlas::ordered_points(structure, line, Eigen::Matrix3d::Identity(), notch);
}

const Points& line_of(const Reading& reading, Structure structure) {
  return structure == Structure::umbilical_notch  ? reading.notch
         : structure == Structure::falciform_line ? reading.falciform
                                                  : reading.margin;
}

constexpr std::array kRead = {Structure::umbilical_notch, Structure::falciform_line,
                              Structure::anterior_margin};

}  // namespace

Readings read_readings(const fs::path& path) {
  const json document = read_json(path);
  const std::string file = path.string();
  if (!document.is_object() || document.value("format", "") != "glisson-readings" ||
      document.value("version", 0) != 1 || document.value("frame", "") != "LPS" ||
      document.value("unit", "") != "mm" || !document.contains("livers") || !document["livers"].is_object())
    throw InputError(file, "format, version, frame, unit, livers", "are not those of readings",
                     "Give a file of format glisson-readings, version 1, LPS, mm");
  Readings readings;
  for (const auto& [liver, list] : document["livers"].items()) {
    if (!list.is_array()) throw InputError(file, liver, "is no list", "Give a list of readings");
    for (const json& one : list) readings[liver].push_back(reading_of(Entry(one, file, liver)));
  }
  return readings;
}

std::map<Structure, Points> truth_of(const std::vector<Reading>& readings) {
  std::map<Structure, Points> truth;
  for (const Structure structure : kRead) {
    Points sum;
    double read = 0.0;  // a margin that does not pass the notch is none
    for (const Reading& reading : readings) {
      const Points points = ordered(structure, line_of(reading, structure), reading.notch);
      if (points.rows() == 0) continue;
      sum = sum.rows() == 0 ? points : Points(sum + points);
      read += 1.0;
    }
    if (sum.rows() > 0) truth[structure] = sum / read;
  }
  return truth;
}

Figures apart(const Readings& readings) {
  Figures figures;
  std::map<std::string, std::vector<double>> found;
  for (const auto& [liver, all] : readings) {
    for (const Reading& reading : all)
      if (reading.again.rows() > 0)
        found["readings_again_"].push_back((reading.again - reading.notch).norm());
    if (all.size() < 2) continue;
    for (const Structure structure : kRead) {
      const Points a = ordered(structure, line_of(all[0], structure), all[0].notch),
                   b = ordered(structure, line_of(all[1], structure), all[1].notch);
      if (a.rows() > 0 && a.rows() == b.rows())
        found[std::string("readings_") + atlas::structure_code(structure) + "_"].push_back(
            (a - b).rowwise().norm().mean());
    }
  }
  for (const auto& [key, distances] : found) {
    double sum = 0.0;
    for (const double distance : distances) sum += distance;
    figures[key + "mean_mm"] = 1e3 * sum / static_cast<double>(distances.size());
    figures[key + "worst_mm"] = 1e3 * *std::max_element(distances.begin(), distances.end());
  }
  return figures;
}

}  // namespace glisson::experiments
