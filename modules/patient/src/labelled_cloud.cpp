// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/patient/labelled_cloud.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/core/statistics.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/geometry/ply_file.h"

namespace glisson {
namespace {

constexpr const char* kExport = "Export the cloud again as PLY";

std::string shown(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", number);
  return text;
}

/// The columns of the vertex element that a cloud has a use for; null: absent.
class Columns {
 public:
  using Column = const std::vector<double>*;

  Columns(std::string file, const PlyElement& vertex) : file_(std::move(file)) {
    const auto column = [&](const char* name) { return column_named(vertex, name); };
    static constexpr const char* kNames[] = {"x", "y", "z", "nx", "ny", "nz"};
    for (int k = 0; k < 6; ++k) (k < 3 ? position_[k] : normal_[k - 3]) = column(kNames[k]);
    for (int k = 0; k < 3; ++k)
      if (position_[k] == nullptr)
        throw InputError(file_, "vertex", "has no property \"" + std::string(kNames[k]) + "\"", kExport);
    const bool any_normal = std::any_of(std::begin(normal_), std::end(normal_), [](Column c) { return c; });
    for (int k = 0; any_normal && k < 3; ++k)
      if (normal_[k] == nullptr)
        throw InputError(file_, "vertex", "has no property \"" + std::string(kNames[k + 3]) + "\"", kExport);
    label_ = column("label");
    sigma_ = column("sigma");
  }

  bool has_normals() const { return normal_[0] != nullptr; }
  bool has_labels() const { return label_ != nullptr; }
  bool has_sigma() const { return sigma_ != nullptr; }

  /// In the file's unit.
  Eigen::RowVector3d position(std::size_t row) const {
    const Eigen::RowVector3d p((*position_[0])[row], (*position_[1])[row], (*position_[2])[row]);
    if (!p.allFinite())
      throw InputError(file_, name(row), "has a coordinate that is not a number",
                       "Remove the point or export the cloud again");
    return p;
  }

  Eigen::RowVector3d normal(std::size_t row) const {
    const Eigen::RowVector3d normal((*normal_[0])[row], (*normal_[1])[row], (*normal_[2])[row]);
    const double length = normal.stableNorm();
    if (!std::isfinite(length) || length < 1e-12)
      throw InputError(file_, name(row), "has a normal without a direction",
                       "Compute the normals again or leave nx ny nz out");
    return normal / length;
  }

  Feature feature(std::size_t row) const {
    const double label = (*label_)[row];
    if (label != 1.0 && label != 2.0 && label != 3.0)
      throw InputError(file_, name(row), "has the label " + shown(label) + ", which is none",
                       "Labels are 1 (surface), 2 (anterior margin) and 3 (umbilical notch)");
    return static_cast<Feature>(static_cast<int>(label));
  }

  /// In the file's unit.
  double sigma(std::size_t row) const {
    const double sigma = (*sigma_)[row];
    if (!std::isfinite(sigma) || sigma < 0.0)
      throw InputError(file_, name(row), "has a sigma that is no standard deviation",
                       "It must be a number of 0 or more");
    return sigma;
  }

 private:
  /// A property of this name as programs spell it: in any case, and behind the "scalar_" that CloudCompare
  /// puts before all that is neither place, colour nor normal. A label that is passed over takes margin and
  /// notch with it.
  Column column_named(const PlyElement& vertex, const std::string& name) const {
    Column found = nullptr;
    std::string first;
    for (const auto& [spelt, values] : vertex.scalars) {
      const std::string plain = lower_case(spelt);
      if (plain != name && plain != "scalar_" + name) continue;
      if (found != nullptr)
        throw InputError(file_, "vertex", "has two columns for \"" + name + "\": " + first + " and " + spelt,
                         kExport);
      found = &values;
      first = spelt;
    }
    return found;
  }

  static std::string name(std::size_t row) { return "vertex " + std::to_string(row); }

  std::string file_;
  Column position_[3] = {}, normal_[3] = {};
  Column label_ = nullptr, sigma_ = nullptr;
};

LabelledCloud cloud_of(const std::string& file, const PlyElement& vertex, double metres) {
  if (vertex.count == 0)
    throw InputError(file, "vertex", "the cloud has no points", "Reconstruct or export it again");
  const Columns columns(file, vertex);
  LabelledCloud cloud;
  cloud.points.resize(vertex.count, 3);
  if (columns.has_normals()) cloud.normals.resize(vertex.count, 3);
  for (Eigen::Index i = 0; i < vertex.count; ++i) {
    const auto row = static_cast<std::size_t>(i);
    cloud.points.row(i) = metres * columns.position(row);
    if (columns.has_normals()) cloud.normals.row(i) = columns.normal(row);
    if (columns.has_labels()) cloud.features.push_back(columns.feature(row));
    if (columns.has_sigma()) cloud.sigma.push_back(metres * columns.sigma(row));
  }
  return cloud;
}

/// Half of a cloud's points lie within this of its middle, metres. Outliers do not count.
double spread(const Points& points) {
  Eigen::RowVector3d centre;
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::VectorXd column = points.col(axis);
    centre[axis] = upper_median(std::vector<double>(column.begin(), column.end()));
  }
  const Eigen::VectorXd distances = (points.rowwise() - centre).rowwise().norm();
  return upper_median(std::vector<double>(distances.begin(), distances.end()));
}

}  // namespace

LabelledCloud rows_of(const LabelledCloud& cloud, const std::vector<int>& rows) {
  LabelledCloud part;
  part.points = cloud.points(rows, Eigen::all);
  if (cloud.normals.rows() > 0) part.normals = cloud.normals(rows, Eigen::all);
  part.eyes = cloud.eyes;
  if (cloud.seen_from.rows() > 0) part.seen_from = cloud.seen_from(rows, Eigen::all);
  for (const int i : rows) {
    const auto at = static_cast<std::size_t>(i);
    if (!cloud.features.empty()) part.features.push_back(cloud.features[at]);
    if (!cloud.sigma.empty()) part.sigma.push_back(cloud.sigma[at]);
    if (!cloud.looks.empty()) part.looks.push_back(cloud.looks[at]);
  }
  return part;
}

LabelledCloud read_cloud(const std::filesystem::path& path, LengthUnit unit) {
  for (const PlyElement& element : read_ply(path))
    if (element.name == "vertex") return cloud_of(path.string(), element, metres_per(unit));
  throw InputError(path.string(), "vertex", "is missing: the file holds no points", kExport);
}

void write_cloud(const std::filesystem::path& path, const LabelledCloud& cloud, LengthUnit unit) {
  const auto n = static_cast<std::size_t>(cloud.size());
  const bool has_normals = cloud.normals.rows() > 0;
  require(!has_normals || cloud.normals.rows() == cloud.points.rows(), "a cloud has a normal for each point");
  require(cloud.features.empty() || cloud.features.size() == n, "a cloud has a label for each point");
  require(cloud.sigma.empty() || cloud.sigma.size() == n, "a cloud has a sigma for each point");
  require(cloud.points.allFinite(), "the points of a cloud are finite");

  std::string text = "ply\nformat binary_little_endian 1.0\ncomment Glisson, left camera's frame, ";
  text += unit_code(unit);
  text +=
      "\nelement vertex " + std::to_string(n) + "\nproperty double x\nproperty double y\nproperty double z\n";
  if (has_normals) text += "property float nx\nproperty float ny\nproperty float nz\n";
  text += "property uchar label\n";
  if (!cloud.sigma.empty()) text += "property float sigma\n";
  text += "end_header\n";
  const double scale = 1.0 / metres_per(unit);
  for (std::size_t i = 0; i < n; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    for (int k = 0; k < 3; ++k) append_little_endian(text, scale * cloud.points(row, k));
    if (has_normals)
      for (int k = 0; k < 3; ++k) append_little_endian(text, static_cast<float>(cloud.normals(row, k)));
    append_little_endian(text, static_cast<std::uint8_t>(cloud.feature(static_cast<int>(i))));
    if (!cloud.sigma.empty()) append_little_endian(text, static_cast<float>(scale * cloud.sigma[i]));
  }
  write_file_atomically(path, text);
}

void require_liver_sized(const LabelledCloud& cloud, LengthUnit unit, const std::string& name) {
  constexpr double kSmallest = 1e-3, kLargest = 0.3;
  if (cloud.size() == 0) return;
  const double found = spread(cloud.points);
  if (found <= kLargest && (found >= kSmallest || cloud.size() < 10)) return;
  std::string remedy = "Check what the file holds";
  for (const LengthUnit other : {LengthUnit::metre, LengthUnit::centimetre, LengthUnit::millimetre}) {
    const double read_so = found / metres_per(unit) * metres_per(other);
    if (read_so <= kLargest && read_so >= kSmallest) remedy = std::string("Read it in ") + unit_code(other);
  }
  char problem[160];
  std::snprintf(problem, sizeof problem,
                "half of its points lie within %.3g m of its middle when read in %s, which is no liver",
                found, unit_code(unit));
  throw InputError(name, "size", problem, remedy);
}

}  // namespace glisson
