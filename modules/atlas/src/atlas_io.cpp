// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <system_error>

#include "glisson/atlas/atlas.h"
#include "glisson/core/claim.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/core/folder_exchange.h"
#include "glisson/core/json_file.h"
#include "glisson/core/word_sum.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/patient/registration.h"

namespace glisson::atlas {
namespace {
namespace fs = std::filesystem;
using nlohmann::json;

constexpr int kVersion = 1;
constexpr const char* kFormat = "glisson-atlas";
constexpr const char *kSheetFile = "atlas.json", *kMeanFile = "mean.vtp";
constexpr double kMm = 1e3;
constexpr double kRounding = 1e-8;  // m2, of three decimals in mm2, and more than that

std::string mode_name(Eigen::Index k) { return "mode_" + std::to_string(k + 1); }
std::string share_name(Structure structure) { return std::string("share_") + structure_code(structure); }

json rows(const Eigen::MatrixXd& matrix, double factor) {
  json list = json::array();
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    json row = json::array();
    // Micrometres are enough, and keep the file small.
    for (Eigen::Index j = 0; j < matrix.cols(); ++j)
      row.push_back(std::round(factor * matrix(i, j) * 1e3) / 1e3);
    list.push_back(row);
  }
  return list;
}

/// Reads fields and names the one that is wrong.
class Sheet {
 public:
  Sheet(const json& document, std::string file, std::string path = {})
      : document_(document), file_(std::move(file)), path_(std::move(path)) {
    if (!document.is_object()) fail("", "is not an object");
  }
  Sheet at(const char* key) const { return {field(key), file_, name(key)}; }
  double number(const char* key) const {
    const json& value = field(key);
    if (!value.is_number() || !std::isfinite(value.get<double>())) fail(key, "is no number");
    return value.get<double>();
  }
  bool has(const char* key) const { return document_.contains(key); }
  std::string text(const char* key) const {
    const json& value = field(key);
    if (!value.is_string()) fail(key, "is no text");
    return value.get<std::string>();
  }
  std::vector<Sheet> list(const char* key) const {
    std::vector<Sheet> sheets;
    const json& value = field(key);
    if (!value.is_array()) fail(key, "is not a list");
    for (std::size_t i = 0; i < value.size(); ++i)
      sheets.emplace_back(value[i], file_, name(key) + "[" + std::to_string(i) + "]");
    return sheets;
  }
  std::vector<std::string> texts(const char* key) const {
    const json& value = field(key);
    if (!value.is_array()) fail(key, "is not a list");
    std::vector<std::string> all;
    for (const json& one : value) {
      if (!one.is_string()) fail(key, "holds something else than texts");
      all.push_back(one.get<std::string>());
    }
    return all;
  }
  const json& field(const char* key) const {
    const auto found = document_.find(key);
    if (found == document_.end()) fail(key, "is missing");
    return *found;
  }
  /// rows x cols numbers over `factor`; -1 columns: any number.
  Eigen::MatrixXd matrix(const json& value, const char* key, Eigen::Index wanted_rows,
                         Eigen::Index wanted_cols, double factor) const {
    if (!value.is_array() || static_cast<Eigen::Index>(value.size()) != wanted_rows)
      fail(key, "needs " + std::to_string(wanted_rows) + " rows");
    Eigen::Index cols = wanted_cols;
    if (cols < 0)
      cols = wanted_rows == 0 || !value[0].is_array() ? 0 : static_cast<Eigen::Index>(value[0].size());
    Eigen::MatrixXd matrix(wanted_rows, cols);
    for (Eigen::Index i = 0; i < wanted_rows; ++i) {
      const json& row = value[static_cast<std::size_t>(i)];
      if (!row.is_array() || static_cast<Eigen::Index>(row.size()) != cols)
        fail(key, "needs " + std::to_string(cols) + " numbers a row");
      for (Eigen::Index j = 0; j < cols; ++j) {
        if (!row[static_cast<std::size_t>(j)].is_number()) fail(key, "holds something else than numbers");
        matrix(i, j) = row[static_cast<std::size_t>(j)].get<double>() / factor;
      }
    }
    return matrix;
  }
  [[noreturn]] void fail(const char* key, const std::string& problem) const {
    throw InputError(file_, name(key), problem, "Build the atlas again, or take another one");
  }

 private:
  std::string name(const char* key) const {
    if (path_.empty()) return key;
    return *key == '\0' ? path_ : path_ + "." + key;
  }
  const json& document_;
  std::string file_, path_;
};

json nine_a_row(const std::vector<Eigen::Matrix3d>& matrices) {
  json list = json::array();
  for (const Eigen::Matrix3d& matrix : matrices) {
    json nine = json::array();
    for (const json& row : rows(matrix, 1.0)) nine.insert(nine.end(), row.begin(), row.end());
    list.push_back(nine);
  }
  return list;
}
json six_a_row(const std::vector<Eigen::Matrix3d>& squares) {
  json list = json::array();
  for (const Eigen::Matrix3d& square : squares) list.push_back(rows(symmetric_row(square), kMm * kMm)[0]);
  return list;
}

json sheets_of(const std::vector<Dependence>& depends) {
  json list = json::array();
  for (const Dependence& one : depends)
    list.push_back({{"on", structure_code(one.on)},
                    {"point", one.point},
                    {"livers", one.livers},
                    {"gains", nine_a_row(one.gains)},
                    {"left_mm2", six_a_row(one.left)}});
  return list;
}

json sheet_of(const StructureStatistics& one) {
  json residuals = json::array();
  for (const Points& residual : one.residuals) residuals.push_back(rows(residual, kMm));
  json sheet = {{"structure", structure_code(one.structure)},
                {"origin", one.origin},
                {"members", one.members},
                {"mean_mm", rows(one.mean, kMm)},
                {"slopes_mm", rows(one.slopes, kMm)},
                {"residuals_mm", residuals},
                {"added_deviation_mm", kMm * one.added_deviation},
                {"added_unusual", one.added_unusual}};
  if (!one.depends.empty()) sheet["depends"] = sheets_of(one.depends);
  if (one.summed_livers == 0) return sheet;
  sheet["summed_livers"] = one.summed_livers;
  sheet["summed_mm2"] = six_a_row(one.summed);
  return sheet;
}

/// What is kept of livers whose residuals are not. @pre there is such
void take_summed(const Sheet& sheet, Eigen::Index count, StructureStatistics& one) {
  const double livers = sheet.number("summed_livers");
  if (!(livers >= 3.0 && livers < 1e6)) sheet.fail("summed_livers", "are fewer than 3");
  one.summed_livers = static_cast<int>(livers);
  const Eigen::MatrixXd squares = sheet.matrix(sheet.field("summed_mm2"), "summed_mm2", count, 6, kMm * kMm);
  for (Eigen::Index k = 0; k < count; ++k) {
    one.summed.push_back(symmetric_matrix(squares.row(k)));
    if (!(one.summed.back().diagonal().minCoeff() > 0.0))
      sheet.fail("summed_mm2", "holds no squares in its first three columns");
  }
}

/// @param of the structure that depends, and how many points it has
Dependence dependence_of(const Sheet& sheet, Structure of, Eigen::Index count) {
  Dependence one;
  const auto on = structure_of(sheet.text("on"));
  if (!on) sheet.fail("on", "is \"" + sheet.text("on") + "\", which is unknown");
  if (*on == of) sheet.fail("on", "is the structure itself");
  one.on = *on;
  const double point = sheet.number("point"), livers = sheet.number("livers");
  if (point != std::floor(point) || point < 0.0 || point >= point_count(*on))
    sheet.fail("point", "is no point of that structure");
  if (!(livers >= 3.0 && livers < 1e6)) sheet.fail("livers", "are fewer than 3");
  one.point = static_cast<int>(point);
  one.livers = static_cast<int>(livers);
  const Eigen::MatrixXd gains = sheet.matrix(sheet.field("gains"), "gains", count, 9, 1.0),
                        left = sheet.matrix(sheet.field("left_mm2"), "left_mm2", count, 6, kMm * kMm);
  for (Eigen::Index k = 0; k < count; ++k) {
    Eigen::Matrix3d& gain = one.gains.emplace_back();
    for (Eigen::Index i = 0; i < 9; ++i) gain(i / 3, i % 3) = gains(k, i);
    one.left.push_back(symmetric_matrix(left.row(k)));
    if (one.left.back().selfadjointView<Eigen::Lower>().eigenvalues().minCoeff() < -kRounding)
      sheet.fail("left_mm2", "holds a matrix that is no covariance");
  }
  return one;
}

StructureStatistics statistics_of(const Sheet& sheet) {
  StructureStatistics one;
  const auto structure = structure_of(sheet.text("structure"));
  if (!structure) sheet.fail("structure", "is \"" + sheet.text("structure") + "\", which is unknown");
  one.structure = *structure;
  one.origin = sheet.text("origin");
  one.members = sheet.texts("members");
  const Eigen::Index count = point_count(*structure);
  one.mean = sheet.matrix(sheet.field("mean_mm"), "mean_mm", count, 3, kMm);
  one.slopes = sheet.matrix(sheet.field("slopes_mm"), "slopes_mm", 3 * count, -1, kMm);
  const json& residuals = sheet.field("residuals_mm");
  const bool is_summed = sheet.has("summed_livers");
  const std::size_t least = is_summed ? 0 : 3;
  if (!residuals.is_array() || residuals.size() != one.members.size() || residuals.size() < least)
    sheet.fail("residuals_mm", "needs one entry a member, three at least");
  if (is_summed) take_summed(sheet, count, one);
  for (const json& residual : residuals)
    one.residuals.emplace_back(sheet.matrix(residual, "residuals_mm", count, 3, kMm));
  one.added_deviation = sheet.number("added_deviation_mm") / kMm;
  if (sheet.has("added_unusual")) one.added_unusual = sheet.number("added_unusual");  // older ones have none
  if (one.added_unusual < 1.0) sheet.fail("added_unusual", "is below 1");
  if (!sheet.has("depends")) return one;  // of a former edition, or it follows nothing
  for (const Sheet& other : sheet.list("depends"))
    one.depends.push_back(dependence_of(other, one.structure, count));
  return one;
}

/// Each on a structure that is there, and on none twice.
void check_dependences(const Atlas& atlas, const Sheet& sheet) {
  for (const StructureStatistics& of : atlas.structures) {
    std::set<Structure> known;
    for (const Dependence& one : of.depends) {
      const std::string key = std::string("structures.") + structure_code(of.structure) + ".depends";
      if (atlas.find(one.on) == nullptr) sheet.fail(key.c_str(), "name a structure that is not there");
      if (!known.insert(one.on).second) sheet.fail(key.c_str(), "name a structure twice");
    }
  }
}

TriangleFile surface_of(const Atlas& atlas) {
  TriangleFile file;
  file.mesh = atlas.mean();
  for (Eigen::Index k = 0; k < atlas.shape.modes.cols(); ++k) {
    const Eigen::VectorXd mode = atlas.shape.modes.col(k);
    file.point_data[mode_name(k)] = Eigen::Map<const Points>(mode.data(), mode.size() / 3, 3);
  }
  for (const StructureStatistics& one : atlas.structures)
    if (one.share.size() > 0) file.point_data[share_name(one.structure)] = one.share;
  return file;
}

void take_modes(Atlas& atlas, const TriangleFile& file, const std::string& name, Eigen::Index count) {
  const Eigen::Index vertices = file.mesh.vertices.rows();
  atlas.shape.modes.resize(3 * vertices, count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const auto found = file.point_data.find(mode_name(k));
    if (found == file.point_data.end() || found->second.cols() != 3 || !found->second.allFinite())
      throw InputError(name, mode_name(k), "is missing, or no vector a vertex",
                       "Build the atlas again, or take another one");
    const Points mode = found->second;
    atlas.shape.modes.col(k) = Eigen::Map<const Eigen::VectorXd>(mode.data(), mode.size());
  }
}

/// An area that no vertex belongs to could never become a landmark.
void take_shares(Atlas& atlas, const TriangleFile& file, const std::string& name) {
  constexpr double kLeastVertices = 1.0;
  for (StructureStatistics& one : atlas.structures) {
    const auto found = file.point_data.find(share_name(one.structure));
    if (found == file.point_data.end() && !is_area(one.structure)) continue;
    const bool is_share = found != file.point_data.end() && found->second.cols() == 1 &&
                          (found->second.array() >= 0.0 && found->second.array() <= 1.0).all();
    if (!is_share || (is_area(one.structure) && found->second.sum() < kLeastVertices))
      throw InputError(name, share_name(one.structure), "is no share from 0 to 1 of each vertex",
                       "Build the atlas again, or take another one");
    one.share = found->second.col(0);
  }
}

/// What else lies in an atlas' folder stays: files by a second name for the same content where there can be
/// one, so that nothing is lost in a kill.
void carry_over(const fs::path& former, const fs::path& fresh) {
  constexpr auto kAll = fs::copy_options::recursive | fs::copy_options::copy_symlinks;
  for (const fs::directory_entry& entry : fs::directory_iterator(former)) {
    const fs::path name = entry.path().filename();
    if (name == kSheetFile || name == kMeanFile) continue;
    std::error_code failure;
    fs::copy(entry.path(), fresh / name, kAll | fs::copy_options::create_hard_links, failure);
    if (!failure) continue;
    fs::remove_all(fresh / name);
    fs::copy(entry.path(), fresh / name, kAll);
  }
}

}  // namespace

void write_atlas(const fs::path& folder, const Atlas& atlas) {
  fs::create_directories(folder);
  write_triangle_mesh(folder / kMeanFile, surface_of(atlas), LengthUnit::millimetre);
  json members = json::array(), structures = json::array(), variances = json::array();
  for (const AtlasMember& one : atlas.members)
    members.push_back({{"name", one.name},
                       {"weight", one.weight},
                       {"size_mm", kMm * one.size},
                       {"unusual", one.unusual},
                       {"mean_distance_mm", kMm * one.mean_distance}});
  for (const StructureStatistics& one : atlas.structures) structures.push_back(sheet_of(one));
  for (const double variance : atlas.shape.variances) variances.push_back(kMm * kMm * variance);
  write_json(folder / kSheetFile, {{"format", kFormat},
                                   {"version", kVersion},
                                   {"name", atlas.name},
                                   {"vertices", atlas.shape.mean.rows()},
                                   {"triangles", atlas.triangles.rows()},
                                   {"surface_sum", sum_of_content(read_file(folder / kMeanFile))},
                                   {"variances_mm2", variances},
                                   {"total_variance_mm2", kMm * kMm * atlas.shape.total_variance},
                                   {"usual", atlas.usual},
                                   {"log_size", atlas.log_size},
                                   {"log_size_deviation", atlas.log_size_deviation},
                                   {"members", members},
                                   {"structures", structures}});
}

void replace_atlas(const fs::path& folder, const Atlas& atlas) {
  const fs::path place = place_for_folder(folder), around = place.parent_path();
  fs::create_directories(around);
  sweep_leftovers(around);
  const TemporaryFolder beside(around);
  const fs::path fresh = beside.path() / place.filename();
  write_atlas(fresh, atlas);
  if (const fs::path former = standing_folder(place, kSheetFile); fs::exists(former)) {
    carry_over(former, fresh);
    fs::permissions(fresh, fs::status(former).permissions());
  }
  flush_to_disk(fresh);
  exchange_folders(fresh, place, kSheetFile);
}

Atlas read_atlas(const fs::path& given) {
  std::error_code ignored;
  const bool is_there = given.empty() || fs::exists(given, ignored);
  const fs::path folder = is_there ? given : standing_folder(place_for_folder(given), kSheetFile);
  const fs::path path = folder / kSheetFile;
  const json document = read_json(path);
  const Sheet sheet(document, path.string());
  if (sheet.text("format") != kFormat) sheet.fail("format", "is not that of an atlas");
  if (sheet.number("version") != kVersion)
    throw InputError(path.string(), "version", "is not " + std::to_string(kVersion),
                     "Build the atlas again with this program");
  Atlas atlas;
  atlas.name = sheet.text("name");
  atlas.usual = sheet.number("usual");
  atlas.log_size = sheet.number("log_size");
  atlas.log_size_deviation = sheet.number("log_size_deviation");
  if (!(atlas.usual > 0.0)) sheet.fail("usual", "is not positive");
  if (!(atlas.log_size_deviation > 0.0)) sheet.fail("log_size_deviation", "is not positive");
  for (const Sheet& one : sheet.list("members"))
    atlas.members.push_back({one.text("name"), one.number("weight"), one.number("size_mm") / kMm,
                             one.number("unusual"), one.number("mean_distance_mm") / kMm});
  for (const Sheet& one : sheet.list("structures")) {
    StructureStatistics known = statistics_of(one);
    if (atlas.find(known.structure) != nullptr) one.fail("structure", "is named twice");
    atlas.structures.push_back(std::move(known));
  }
  if (atlas.structures.empty()) sheet.fail("structures", "holds none");
  check_dependences(atlas, sheet);
  const json& variances = sheet.field("variances_mm2");
  if (!variances.is_array()) sheet.fail("variances_mm2", "is not a list");
  atlas.shape.variances.resize(static_cast<Eigen::Index>(variances.size()));
  for (std::size_t k = 0; k < variances.size(); ++k) {
    if (!variances[k].is_number() || !(variances[k].get<double>() > 0.0))
      sheet.fail("variances_mm2", "holds something else than numbers above 0");
    atlas.shape.variances[static_cast<Eigen::Index>(k)] = variances[k].get<double>() / (kMm * kMm);
  }
  atlas.shape.total_variance = sheet.number("total_variance_mm2") / (kMm * kMm);
  const fs::path surface = folder / kMeanFile;
  const TriangleFile file = read_triangle_file(surface, LengthUnit::millimetre);
  if (static_cast<double>(file.mesh.vertex_count()) != sheet.number("vertices") ||
      static_cast<double>(file.mesh.triangle_count()) != sheet.number("triangles"))
    throw InputError(surface.string(), "vertices", "do not belong to this atlas.json",
                     "Copy both files of one atlas");
  check_liver_size(file.mesh.vertices, LengthUnit::millimetre, surface.string());
  atlas.triangles = file.mesh.triangles;
  atlas.shape.mean = file.mesh.vertices;
  take_modes(atlas, file, surface.string(), atlas.shape.variances.size());
  take_shares(atlas, file, surface.string());
  // Atlases on one base have as many vertices; those of former editions have no sum.
  if (sheet.has("surface_sum") && sheet.text("surface_sum") != sum_of_content(read_file(surface)))
    throw InputError(surface.string(), "vertices", "do not belong to this atlas.json",
                     "Copy both files of one atlas");
  return atlas;
}

}  // namespace glisson::atlas
