// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/patient/overlay_record.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "glisson/core/error.h"
#include "glisson/core/json_file.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/geometry/rigid.h"
#include "glisson/patient/label_map.h"
#include "named.h"

namespace glisson {
namespace {

constexpr const char* kAgain = "registered_again";

using nlohmann::json;

constexpr Level kLevels[] = {Level::valid, Level::degraded, Level::withdrawn};

json rows_of(const Eigen::MatrixXd& matrix) {
  json rows = json::array();
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    json row = json::array();
    for (Eigen::Index k = 0; k < matrix.cols(); ++k) row.push_back(matrix(i, k));
    rows.push_back(row);
  }
  return rows;
}

/// A field of Evidence in the file: its name, the factor on the value, and whether a negative value means
/// "not known" (then it is left out).
struct EvidenceField {
  const char* name;
  double Evidence::*value;
  double per = 1.0;
  bool may_be_unknown = false;
};
constexpr EvidenceField kEvidence[] = {{"supported", &Evidence::supported},
                                       {"missing", &Evidence::missing},
                                       {"gap", &Evidence::gap},
                                       {"local", &Evidence::local},
                                       {"behind", &Evidence::behind},
                                       {"before", &Evidence::before},
                                       {"lifted", &Evidence::lifted},
                                       {"pull_mm", &Evidence::pull, 1e3},
                                       {"pull_sigma_mm", &Evidence::pull_sigma, 1e3},
                                       {"contrast", &Evidence::contrast},
                                       {"motion", &Evidence::motion},
                                       {"fresh", &Evidence::fresh, 1.0, true},
                                       {"rows_px", &Evidence::rows}};

json evidence_object(const Evidence& evidence) {
  json object = json::object();
  for (const EvidenceField& field : kEvidence) {
    const double value = field.per * (evidence.*field.value);
    if (field.may_be_unknown && value < 0.0) continue;
    if (std::isfinite(value)) object[field.name] = value;  // JSON has no other numbers
  }
  return object;
}

/// To 0.1 micrometres: more digits would only make the file long.
json nodes_rows(const Points& nodes, double per) {
  json rows = json::array();
  const double step = 1e-7 * per;
  const auto rounded = [&](double metres) { return std::round(metres * per / step) * step; };
  for (Eigen::Index i = 0; i < nodes.rows(); ++i)
    rows.push_back({rounded(nodes(i, 0)), rounded(nodes(i, 1)), rounded(nodes(i, 2))});
  return rows;
}

json verdict_line(const LesionVerdict& verdict, double per) {
  json line = {{"lesion", structure_name(verdict.lesion)},
               {"level", level_code(verdict.level)},
               {"reason", lesion_reason_code(verdict.reason)},
               {"centre", {per * verdict.centre.x(), per * verdict.centre.y(), per * verdict.centre.z()}},
               {"radius", per * verdict.radius}};
  if (verdict.reach > 0.0) {
    line["covariance"] = rows_of(per * per * verdict.covariance);
    line["expected_error"] = per * verdict.expected;
    line["reach_95"] = per * verdict.reach;
  }
  if (std::isfinite(verdict.support)) line["nearest_points"] = per * verdict.support;
  line["unseen_seconds"] = verdict.unseen;
  return line;
}

double number(const json& object, const char* field) {
  const double value = object.at(field).get<double>();
  if (!std::isfinite(value)) throw std::invalid_argument(std::string(field) + " is not a finite number");
  return value;
}

double length(const json& object, const char* field) {
  const double value = number(object, field);
  if (value < 0.0) throw std::invalid_argument(std::string(field) + " is negative");
  return value;
}

template <int Rows>
Eigen::Matrix<double, Rows, Rows> square_of(const json& rows, const char* field) {
  Eigen::Matrix<double, Rows, Rows> matrix;
  if (rows.size() != Rows) throw std::invalid_argument(std::string(field) + " has another size");
  for (std::size_t i = 0; i < Rows; ++i) {
    if (rows[i].size() != Rows) throw std::invalid_argument(std::string(field) + " has another size");
    for (std::size_t k = 0; k < Rows; ++k)
      matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) = rows[i][k].get<double>();
  }
  if (!matrix.allFinite()) throw std::invalid_argument(std::string(field) + " is not finite");
  return matrix;
}

Evidence evidence_of(const json& object) {
  Evidence evidence;
  evidence.judged = true;
  for (const EvidenceField& field : kEvidence)
    if (object.contains(field.name)) evidence.*field.value = number(object, field.name) / field.per;
  return evidence;
}

Points nodes_of(const json& rows, double metres) {
  Points nodes(static_cast<Eigen::Index>(rows.size()), 3);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].size() != 3) throw std::invalid_argument("nodes have another size");
    for (std::size_t k = 0; k < 3; ++k)
      nodes(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) = metres * rows[i][k].get<double>();
  }
  if (!nodes.allFinite()) throw std::invalid_argument("nodes are not finite");
  return nodes;
}

LesionVerdict verdict_of(const json& line, double metres) {
  LesionVerdict verdict;
  const auto name = line.at("lesion").get<std::string>();
  const std::optional<Label> lesion = structure_named(name);
  if (!lesion || !is_lesion(*lesion)) throw std::invalid_argument("lesion '" + name + "' is none");
  verdict.lesion = *lesion;
  verdict.level = named(kLevels, level_code, line.at("level").get<std::string>(), "a lesion's level");
  verdict.reason =
      named(kLesionReasons, lesion_reason_code, line.at("reason").get<std::string>(), "a lesion's reason");
  const json& centre = line.at("centre");
  if (centre.size() != 3) throw std::invalid_argument("centre has another size");
  verdict.centre =
      metres * Eigen::Vector3d(centre[0].get<double>(), centre[1].get<double>(), centre[2].get<double>());
  verdict.radius = metres * length(line, "radius");
  if (line.contains("reach_95")) {
    verdict.covariance = metres * metres * square_of<3>(line.at("covariance"), "covariance");
    verdict.expected = metres * length(line, "expected_error");
    verdict.reach = metres * length(line, "reach_95");
  }
  verdict.support = line.contains("nearest_points") ? metres * length(line, "nearest_points")
                                                    : std::numeric_limits<double>::infinity();
  verdict.unseen = length(line, "unseen_seconds");
  return verdict;
}

OverlayLine line_of(const json& object) {
  OverlayLine line;
  line.number = whole_number(object, "frame");
  OverlayFrame& overlay = line.overlay;
  overlay.index = line.number;
  overlay.seconds = number(object, "seconds");
  overlay.doubtful = object.at("doubtful").get<bool>();
  overlay.validity = named(kValidities, validity_code, object.at("reason").get<std::string>(), "reason");
  if (object.at("level").get<std::string>() != level_code(overlay.level()))
    throw std::invalid_argument("level and reason contradict each other");
  if (object.contains("mask")) {
    const json& mask = object.at("mask");
    overlay.mask =
        MaskUse{length(mask, "share"), length(mask, "age_seconds"), whole_number(mask, "held_out")};
  }
  if (object.contains("points")) {
    const json& points = object.at("points");
    overlay.tracked_left = whole_number(points, "left");
    overlay.tracked_right = whole_number(points, "right");
    overlay.pairs = whole_number(points, "pairs");
  }
  if (object.contains("evidence")) overlay.evidence = evidence_of(object.at("evidence"));
  if (object.contains("follow_ms")) overlay.milliseconds = length(object, "follow_ms");
  if (object.contains("remedy")) line.remedy = object.at("remedy").get<std::string>();
  if (object.contains("film_frame")) line.film_frame = whole_number(object, "film_frame");
  if (object.contains("age_ms")) line.age = 1e-3 * length(object, "age_ms");
  line.nodes_here = object.contains("nodes");
  if (object.at("mesh").is_null() && !line.nodes_here) return line;
  if (!object.at("mesh").is_null()) {
    line.mesh = object.at("mesh").get<std::string>();
    if (line.mesh.empty() || std::filesystem::path(line.mesh).filename() != line.mesh)
      throw std::invalid_argument("mesh '" + line.mesh + "' is no file beside it");
  }
  line.unit = named(kLengthUnits, unit_code, object.at("unit").get<std::string>(), "unit");
  const double metres = metres_per(line.unit);
  line.camera_from_model = square_of<4>(object.at("camera_from_model"), "camera_from_model");
  line.camera_from_model->topRightCorner<3, 1>() *= metres;
  overlay.residual = 1e-3 * length(object, "residual_mm");
  for (const json& lesion : object.at("lesions")) overlay.lesions.push_back(verdict_of(lesion, metres));
  if (line.nodes_here) overlay.nodes_in_camera = nodes_of(object.at("nodes"), metres);
  return line;
}

}  // namespace

std::optional<Eigen::Matrix4d> pose_of(const PointsIn<CtFrame>& at_rest, const OverlayFrame& overlay) {
  if (overlay.nodes_in_camera.rows() == 0) return {};
  return fit_rigid<CameraFrame, CtFrame>(at_rest, overlay.nodes_in_camera).matrix();
}

std::string overlay_line(const OverlayLine& line) {
  const OverlayFrame& overlay = line.overlay;
  json object = {{"frame", line.number},
                 {"seconds", overlay.seconds},
                 {"level", level_code(overlay.level())},
                 {"reason", validity_code(overlay.validity)},
                 {"doubtful", overlay.doubtful},
                 {"mesh", nullptr},
                 {"camera_from_model", nullptr}};
  if (overlay.mask)
    object["mask"] = {{"share", overlay.mask->share},
                      {"age_seconds", overlay.mask->age},
                      {"held_out", overlay.mask->held_out}};
  object["points"] = {
      {"left", overlay.tracked_left}, {"right", overlay.tracked_right}, {"pairs", overlay.pairs}};
  object["follow_ms"] = overlay.milliseconds;
  if (overlay.evidence.judged) object["evidence"] = evidence_object(overlay.evidence);
  if (!line.remedy.empty()) object["remedy"] = line.remedy;
  if (line.film_frame) object["film_frame"] = *line.film_frame;
  if (line.age) object["age_ms"] = 1e3 * *line.age;
  if (line.mesh.empty() && !line.nodes_here) return object.dump();
  require(line.camera_from_model.has_value(), "a line with nodes has their pose");
  const double per = 1.0 / metres_per(line.unit);
  Eigen::Matrix4d pose = *line.camera_from_model;
  pose.topRightCorner<3, 1>() *= per;
  if (!line.mesh.empty()) object["mesh"] = line.mesh;
  if (line.nodes_here) object["nodes"] = nodes_rows(overlay.nodes_in_camera, per);
  object["camera_from_model"] = rows_of(pose);
  object["unit"] = unit_code(line.unit);
  object["residual_mm"] = 1e3 * overlay.residual;
  object["lesions"] = json::array();
  for (const LesionVerdict& verdict : overlay.lesions)
    object["lesions"].push_back(verdict_line(verdict, per));
  return object.dump();
}

std::string overlay_record_end(bool complete, int frames) {
  return json{{"complete", complete}, {"frames", frames}}.dump();
}

std::string again_line(const AgainLine& line) {
  return json{{"frame", line.frame},
              {"seconds", line.seconds},
              {kAgain,
               {{"taken", line.is_taken},
                {"former_gap_mm", 1e3 * line.former_gap},
                {"gap_mm", 1e3 * line.gap},
                {"moved_mean_mm", 1e3 * line.moved}}}}
      .dump();
}

OverlayRecord read_overlay_record(const std::filesystem::path& path) {
  OverlayRecord record;
  for_each_json_line(path, "Give what 'glisson track' wrote", [&record](const json& object) {
    if (object.contains("complete"))
      record.complete = object.at("complete").get<bool>();
    else if (!object.contains("correct") && !object.contains(kAgain))  // by hand: see correction.h
      record.frames.push_back(line_of(object));
  });
  return record;
}

}  // namespace glisson
