// SPDX-License-Identifier: GPL-3.0-or-later
#include "case_stereo.h"

#include <array>
#include <cmath>
#include <concepts>
#include <nlohmann/json.hpp>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "glisson/core/error.h"
#include "glisson/core/json_file.h"
#include "glisson/engine/parts/rig.h"

namespace glisson::engine {
namespace fs = std::filesystem;
using nlohmann::json;
namespace {

constexpr LengthUnit kUnit = LengthUnit::millimetre;
constexpr double kMm2 = 1e-6;  ///< square millimetre in square metres
constexpr const char* kAgain = "Reconstruct the surface again";

/// Entries of points.json, refused by name.
class PointsFile {
 public:
  explicit PointsFile(const fs::path& path) : file_(path.string()), document_(read_json(path)) {
    if (!document_.is_object()) refuse("", "is not a JSON object");
  }

  [[noreturn]] void refuse(const std::string& field, const std::string& problem) const {
    throw InputError(file_, field, problem, kAgain);
  }
  /// @param group of the document; empty: the document itself.
  const json& entry(const std::string& group, const char* field) const {
    const json* in = &document_;
    if (!group.empty()) {
      const auto found = document_.find(group);
      if (found == document_.end() || !found->is_object()) refuse(group, "is missing");
      in = &*found;
    }
    const auto found = in->find(field);
    if (found == in->end()) refuse(name(group, field), "is missing");
    return *found;
  }
  template <class T>
  T get(const std::string& group, const char* field) const {
    try {
      return entry(group, field).get<T>();
    } catch (const json::exception&) {
      refuse(name(group, field), "is not of the right kind");
    }
  }
  /// A finite number.
  double number(const std::string& group, const char* field) const {
    const auto value = get<double>(group, field);
    if (!std::isfinite(value)) refuse(name(group, field), "is not a number");
    return value;
  }
  /// A number that may be unknown (written as null).
  double figure(const std::string& group, const char* field) const {
    return entry(group, field).is_null() ? std::nan("") : number(group, field);
  }
  template <class Codes>
  auto coded(const std::string& group, const char* field, const Codes& codes) const {
    const auto given = get<std::string>(group, field);
    if (const auto value = value_in(codes, given)) return *value;
    refuse(name(group, field), "is \"" + given + "\", which is unknown");
  }

 private:
  static std::string name(const std::string& group, const char* field) {
    return group.empty() ? field : group + "." + field;
  }

  std::string file_;
  json document_;
};

/// Writes the entries of a group.
struct EntriesWritten {
  json group = json::object();

  void operator()(const char* field, const auto& value) { group[field] = value; }
  void operator()(const char* field, const auto& value, const auto& codes) {
    group[field] = code_in(codes, value);
  }
};

/// Reads them.
struct EntriesRead {
  const PointsFile& file;
  std::string group;
  bool may_be_unknown = false;  ///< its numbers: see PointsFile::figure()

  template <class T>
  void operator()(const char* field, T& value) const {
    value = file.get<T>(group, field);
  }
  void operator()(const char* field, double& value) const {
    value = may_be_unknown ? file.figure(group, field) : file.number(group, field);
  }
  void operator()(const char* field, auto& value, const auto& codes) const {
    value = file.coded(group, field, codes);
  }
};

/// Const where it is written.
template <class T, class Value>
concept Any = std::same_as<std::remove_const_t<T>, Value>;

void each_entry(Any<stereo::ReconstructOptions> auto& o, auto&& entry) {
  entry("method", o.method, stereo::kMethodCodes);
  entry("kind", o.kind, stereo::kFeatureCodes);
  entry("features", o.features);
  entry("ratio", o.ratio);
  entry("epipolar_px", o.epipolar_px);
  entry("reprojection_px", o.reprojection_px);
  entry("near_m", o.near);
  entry("far_m", o.far);
  entry("points_per_cm2", o.points_per_cm2);
  entry("patch", o.patch);
  entry("smooth", o.smooth);
  entry("least_density_per_cm2", o.least_density_per_cm2);
  entry("find_circle", o.find_circle);
}

void each_entry(Any<stereo::ReconstructReport> auto& r, auto&& entry) {
  entry("method", r.method, stereo::kMethodCodes);
  entry("features_left", r.features_left);
  entry("features_right", r.features_right);
  entry("matches", r.matches);
  entry("points", r.points);
  entry("area_cm2", r.area_cm2);
  entry("density_per_cm2", r.density_per_cm2);
  entry("row_offset_px", r.row_offset_px);
  entry("epipolar_rms_px", r.epipolar_rms_px);
  entry("sigma_median_m", r.sigma_median);
  entry("misfit", r.misfit);
}

void each_entry(Any<stereo::DensityMap> auto& map, auto&& entry) {
  entry("columns", map.columns);
  entry("rows", map.rows);
  entry("cell_px", map.cell);
  entry("least_per_cm2", map.least_per_cm2);
  entry("area_cm2", map.area_cm2);
  entry("covered", map.covered);
  entry("per_cm2", map.per_cm2);
}

json group_of(const auto& value) {
  EntriesWritten entries;
  each_entry(value, entries);
  return entries.group;
}

stereo::ReconstructOptions read_options(const PointsFile& file) {
  const std::string group = "options";
  stereo::ReconstructOptions o;
  each_entry(o, EntriesRead{file, group});
  try {
    o.validate();
  } catch (const PreconditionError& failure) {
    file.refuse(group, failure.what());
  }
  return o;
}

stereo::ReconstructReport read_report(const PointsFile& file) {
  stereo::ReconstructReport r;
  each_entry(r, EntriesRead{file, "report", true});
  return r;
}

stereo::DensityMap read_density(const PointsFile& file) {
  stereo::DensityMap map;
  each_entry(map, EntriesRead{file, "density"});
  if (map.columns < 0 || map.rows < 0 || map.cell < 1 ||
      map.per_cm2.size() != static_cast<std::size_t>(map.columns) * static_cast<std::size_t>(map.rows))
    file.refuse("density.per_cm2", "holds " + std::to_string(map.per_cm2.size()) + " cells, not " +
                                       std::to_string(map.columns) + " x " + std::to_string(map.rows));
  return map;
}

/// Upper triangle, row by row: xx xy xz yy yz zz, mm2.
json written(const std::vector<Eigen::Matrix3d>& covariance) {
  json list = json::array();
  for (const Eigen::Matrix3d& c : covariance)
    list.push_back(
        {c(0, 0) / kMm2, c(0, 1) / kMm2, c(0, 2) / kMm2, c(1, 1) / kMm2, c(1, 2) / kMm2, c(2, 2) / kMm2});
  return list;
}

std::vector<Eigen::Matrix3d> read_covariance(const PointsFile& file, int points) {
  std::vector<Eigen::Matrix3d> covariance;
  for (const auto& six : file.get<std::vector<std::vector<double>>>("", "covariance_mm2")) {
    if (six.size() != 6) file.refuse("covariance_mm2", "has an entry that is not of six numbers");
    Eigen::Matrix3d c;
    c << six[0], six[1], six[2], six[1], six[3], six[4], six[2], six[4], six[5];
    covariance.push_back(kMm2 * c);
  }
  if (covariance.size() != static_cast<std::size_t>(points))
    file.refuse("covariance_mm2", "is of " + std::to_string(covariance.size()) + " points, whole.ply holds " +
                                      std::to_string(points));
  return covariance;
}

bool close(double a, double b) { return std::abs(a - b) <= 1e-6 * std::max(1.0, std::abs(a)); }

}  // namespace

void write_points(const fs::path& folder, const CaseState& state, const PairPoints& points) {
  require(points.whole != nullptr && points.whole->cloud.size() > 0, "points that are saved have a cloud");
  fs::create_directory(folder / "points");
  write_cloud(folder / "points/whole.ply", points.whole->cloud, kUnit);
  write_json(folder / "points/points.json",
             {{"frame_identity", points.frame_identity},
              // Points of a former pair or calibration are shown, but not labelled anew.
              {"of_the_frame", points.frame == state[part::frame] && state[part::frame] != nullptr},
              {"of_the_calibration", points.rig == state[part::rig] && state[part::rig] != nullptr},
              {"options", group_of(points.options)},
              {"report", group_of(points.whole->report)},
              {"area_cm2", points.area_cm2},
              {"density_per_cm2", points.density_per_cm2},
              {"density", group_of(points.density)},
              {"covariance_mm2", written(points.whole->covariance)}});
}

std::shared_ptr<const PairPoints> read_points(const fs::path& folder, const CaseState& state) {
  const PointsFile file(folder / "points/points.json");
  PairPoints points;
  points.frame_identity = file.get<std::string>("", "frame_identity");
  if (file.get<bool>("", "of_the_frame")) {
    if (!state[part::frame])
      file.refuse("of_the_frame", "says that they are of the case's pictures, there are none");
    const StereoFrame& frame = state[part::frame]->frame;
    const std::string identity = stereo::frame_identity(frame.left, frame.right);
    if (identity != points.frame_identity)
      file.refuse("frame_identity",
                  "is " + points.frame_identity + ", that of the case's pictures " + identity);
    points.frame = state[part::frame];
  }
  if (file.get<bool>("", "of_the_calibration")) points.rig = state[part::rig];
  points.options = read_options(file);
  points.area_cm2 = file.number("", "area_cm2");
  points.density_per_cm2 = file.number("", "density_per_cm2");
  points.density = read_density(file);
  stereo::Reconstructed whole;
  whole.cloud = read_cloud(folder / "points/whole.ply", kUnit);
  whole.report = read_report(file);
  whole.covariance = read_covariance(file, whole.cloud.size());
  if (whole.cloud.normals.rows() == 0)  // labels are given by them
    throw InputError((folder / "points/whole.ply").string(), "nx, ny, nz", "are missing", kAgain);
  points.whole = std::make_shared<const stereo::Reconstructed>(std::move(whole));
  return std::make_shared<const PairPoints>(std::move(points));
}

bool same_pair_points(const PairPoints& a, const PairPoints& b) {
  const LabelledCloud &p = a.whole->cloud, &q = b.whole->cloud;
  if (p.size() != q.size() || p.normals.rows() != q.normals.rows() || p.sigma.size() != q.sigma.size() ||
      a.whole->covariance.size() != b.whole->covariance.size())
    return false;
  for (std::size_t i = 0; i < p.sigma.size(); ++i)
    if (!close(1e3 * p.sigma[i], 1e3 * q.sigma[i])) return false;
  return (p.points - q.points).cwiseAbs().maxCoeff() < 1e-6 &&
         (p.normals.rows() == 0 || (p.normals - q.normals).cwiseAbs().maxCoeff() < 1e-5) &&
         a.options == b.options && a.frame_identity == b.frame_identity &&
         a.whole->report.method == b.whole->report.method && close(a.density_per_cm2, b.density_per_cm2) &&
         close(a.area_cm2, b.area_cm2) && a.density.per_cm2 == b.density.per_cm2;
}

}  // namespace glisson::engine
