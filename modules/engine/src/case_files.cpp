// SPDX-License-Identifier: GPL-3.0-or-later
#include "case_files.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>
#include <utility>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/core/json_file.h"
#include "glisson/engine/case_io.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/geometry/vtk_xml_file.h"
#include "glisson/patient/label_map.h"

namespace glisson::engine {
namespace fs = std::filesystem;
using nlohmann::json;
namespace {

constexpr double kMillimetre = 1e-3;
constexpr double kFarthestMm = 1e5;  // from a scanner's origin

vtkNew<vtkIntArray> int_array(const char* name) {
  vtkNew<vtkIntArray> array;
  array->SetName(name);
  return array;
}

vtkNew<vtkPolyData> vessels_to_vtk(const std::vector<VesselTree>& trees) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkDoubleArray> radii;
  radii->SetName("radius_mm");
  auto tree_of_point = int_array("tree"), structures = int_array("structures"), roots = int_array("roots");
  for (std::size_t i = 0; i < trees.size(); ++i) {
    const VesselTree& tree = trees[i];
    const vtkIdType first = points->GetNumberOfPoints();
    for (Eigen::Index k = 0; k < tree.nodes.rows(); ++k) {
      const Eigen::Vector3d p = tree.nodes.row(k).transpose() / kMillimetre;
      points->InsertNextPoint(p.data());
      radii->InsertNextValue(tree.radii[static_cast<std::size_t>(k)] / kMillimetre);
      tree_of_point->InsertNextValue(static_cast<int>(i));
    }
    for (const auto& beam : tree.beams) {
      const vtkIdType ends[2] = {first + beam[0], first + beam[1]};
      lines->InsertNextCell(2, ends);
    }
    structures->InsertNextValue(tree.structure);
    roots->InsertNextValue(tree.root);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetLines(lines);
  data->GetPointData()->AddArray(radii);
  data->GetPointData()->AddArray(tree_of_point);
  data->GetFieldData()->AddArray(structures);
  data->GetFieldData()->AddArray(roots);
  return data;
}

}  // namespace

void write_vessels(const fs::path& path, const std::vector<VesselTree>& trees) {
  // In memory first: VTK's XML writers crash on a disk that fills up.
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(vessels_to_vtk(trees));
  writer->SetWriteToOutputString(true);
  writer->Write();
  write_file_atomically(path, writer->GetOutputString());
}

namespace {

/// A column of numbers in one of the file's tables. @throws InputError it is missing or of another width.
Eigen::VectorXd column(const fs::path& path, const NamedArrays& arrays, const char* name) {
  const auto found = arrays.find(name);
  if (found == arrays.end() || found->second.cols() != 1)
    throw InputError(path.string(), name, "is missing, or has several columns", "Build the model anew");
  return found->second.col(0);
}

}  // namespace

std::vector<VesselTree> read_vessels(const fs::path& path) {
  const VtkXmlFile file = read_vtk_xml(path);
  const Eigen::VectorXd structures = column(path, file.field_data, "structures"),
                        roots = column(path, file.field_data, "roots");
  if (roots.size() != structures.size())
    throw InputError(path.string(), "roots", "are not as many as the trees", "Build the model anew");
  const Eigen::Index count = file.points.rows();
  const Eigen::VectorXd none;
  const Eigen::VectorXd radii = count > 0 ? column(path, file.point_data, "radius_mm") : none,
                        tree_of_point = count > 0 ? column(path, file.point_data, "tree") : none;
  if (!file.points.allFinite() || !radii.allFinite())
    throw InputError(path.string(), "points", "hold a number that is not finite", "Build the model anew");
  std::vector<VesselTree> trees(static_cast<std::size_t>(structures.size()));
  for (std::size_t i = 0; i < trees.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    if (!(structures[k] >= 0.0 && structures[k] <= 65535.0) ||
        !(roots[k] >= -1.0 && roots[k] <= static_cast<double>(count)))
      throw InputError(path.string(), "structures, roots", "hold what is no label or no node",
                       "Build the model anew");
    trees[i].structure = static_cast<Label>(structures[k]);
    trees[i].root = static_cast<int>(roots[k]);
  }
  std::vector<int> local(static_cast<std::size_t>(count));
  std::vector<int> sizes(trees.size(), 0);
  const auto tree_at = [&](long point) {
    const double tree = tree_of_point[point];
    if (!(tree >= 0.0 && tree < static_cast<double>(trees.size())))
      throw InputError(path.string(), "tree", "names a tree that is not there", "Build the model anew");
    return static_cast<std::size_t>(tree);
  };
  for (Eigen::Index p = 0; p < count; ++p) {
    local[static_cast<std::size_t>(p)] = sizes[tree_at(p)]++;
    trees[tree_at(p)].radii.push_back(radii[p] * kMillimetre);
  }
  for (std::size_t i = 0; i < trees.size(); ++i) {
    if (trees[i].root >= std::max(1, sizes[i]))
      throw InputError(path.string(), "roots", "hold a node that is not there", "Build the model anew");
    trees[i].nodes.resize(sizes[i], 3);
  }
  for (Eigen::Index p = 0; p < count; ++p)
    trees[tree_at(p)].nodes.row(local[static_cast<std::size_t>(p)]) = kMillimetre * file.points.row(p);
  for (const std::vector<long>& ends : file.cells) {
    if (ends.size() != 2 || tree_at(ends[0]) != tree_at(ends[1]))
      throw InputError(path.string(), "lines", "a beam does not join two nodes of one tree",
                       "Build the model anew");
    trees[tree_at(ends[0])].beams.push_back(
        {local[static_cast<std::size_t>(ends[0])], local[static_cast<std::size_t>(ends[1])]});
  }
  return trees;
}

json points_to_json(const Points& points) {
  json array = json::array();
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    array.push_back({points(i, 0) / kMillimetre, points(i, 1) / kMillimetre, points(i, 2) / kMillimetre});
  return array;
}

Points points_from_json(const json& array, const std::string& file, const std::string& field) {
  const auto refuse = [&](const std::string& problem) {
    throw InputError(file, field, problem, "Write it as a list of [x, y, z] in millimetres (LPS)");
  };
  if (!array.is_array()) refuse("is not a list");
  Points points(static_cast<Eigen::Index>(array.size()), 3);
  for (std::size_t i = 0; i < array.size(); ++i) {
    const json& triple = array[i];
    if (!triple.is_array() || triple.size() != 3) refuse("entry " + std::to_string(i) + " is not a triple");
    for (std::size_t k = 0; k < 3; ++k) {
      if (!triple[k].is_number())
        refuse("entry " + std::to_string(i) + " holds something that is not a number");
      if (!(std::abs(triple[k].get<double>()) <= kFarthestMm))
        refuse("entry " + std::to_string(i) + " is nowhere near a patient");
      points(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) =
          triple[k].get<double>() * kMillimetre;
    }
  }
  return points;
}

bool same_points(const Points& a, const Points& b) {
  constexpr double kMicrometre = 1e-6;
  return a.rows() == b.rows() && (a.rows() == 0 || (a - b).cwiseAbs().maxCoeff() < kMicrometre);
}

namespace {

double deviation_in(const json& value, const std::string& file, const char* field) {
  if (!value.is_number() || !(value.get<double>() >= 0.0) || !std::isfinite(value.get<double>()))
    throw InputError(file, field, "is no deviation", "Give millimetres from 0, or leave the field out");
  return 1e-3 * value.get<double>();
}

/// Files of before have none: all was a person's.
void take_deviations(const json& document, const std::string& file, Landmarks& landmarks) {
  if (document.contains("umbilical_notch_deviation_mm"))
    landmarks.notch_deviation =
        deviation_in(document["umbilical_notch_deviation_mm"], file, "umbilical_notch_deviation_mm");
  if (!document.contains("anterior_margin_deviation_mm")) return;
  const json& list = document["anterior_margin_deviation_mm"];
  if (!list.is_array() || static_cast<Eigen::Index>(list.size()) != landmarks.anterior_margin.rows())
    throw InputError(file, "anterior_margin_deviation_mm", "are not as many as points",
                     "Give one a point of the margin, or leave the field out");
  landmarks.margin_deviation.resize(static_cast<Eigen::Index>(list.size()));
  for (std::size_t i = 0; i < list.size(); ++i)
    landmarks.margin_deviation[static_cast<Eigen::Index>(i)] =
        deviation_in(list[i], file, "anterior_margin_deviation_mm");
}

}  // namespace

Landmarks read_landmarks(const fs::path& path) {
  const json document = read_json(path);
  const std::string file = path.string();
  if (!document.is_object())
    throw InputError(file, "", "is not a JSON object", "Give anterior_margin, umbilical_notch or vena_cava");
  const auto other = [&](const char* key, const char* than) {
    return document.contains(key) && document[key] != than;
  };
  if (other("frame", "LPS") || other("unit", "mm"))
    throw InputError(file, "frame, unit", "landmarks are read in LPS millimetres only",
                     "Convert them, or correct the two fields");
  Landmarks landmarks;
  const auto take = [&](const char* field, Points& into) {
    if (document.contains(field)) into = points_from_json(document[field], file, field);
  };
  take("anterior_margin", landmarks.anterior_margin);
  take("umbilical_notch", landmarks.umbilical_notch);
  take("vena_cava", landmarks.vena_cava);
  take_deviations(document, file, landmarks);
  if (landmarks.empty() && landmarks.vena_cava.rows() == 0)
    throw InputError(file, "", "holds no landmark", "Give anterior_margin, umbilical_notch or vena_cava");
  return landmarks;
}

void write_landmarks(const fs::path& path, const Landmarks& landmarks) {
  json document = {{"frame", "LPS"}, {"unit", "mm"}};
  if (landmarks.anterior_margin.rows() > 0)
    document["anterior_margin"] = points_to_json(landmarks.anterior_margin);
  if (landmarks.umbilical_notch.rows() > 0)
    document["umbilical_notch"] = points_to_json(landmarks.umbilical_notch);
  if (landmarks.margin_deviation.size() > 0) {
    json list = json::array();
    for (const double deviation : landmarks.margin_deviation) list.push_back(1e3 * deviation);
    document["anterior_margin_deviation_mm"] = list;
  }
  if (landmarks.notch_deviation > 0.0)
    document["umbilical_notch_deviation_mm"] = 1e3 * landmarks.notch_deviation;
  if (landmarks.vena_cava.rows() > 0) document["vena_cava"] = points_to_json(landmarks.vena_cava);
  write_json(path, document);
}

namespace {

const std::string kDoubt = "doubt_";
const std::string kTermination = "termination_";    ///< before its code
const std::string kCovariance = "_covariance_mm2";  ///< behind a lesion's or a fork's name
const std::string kFork = "_centre_radius_mm";      ///< behind a fork's name

Eigen::MatrixXd number(double value) { return Eigen::MatrixXd::Constant(1, 1, value); }

/// What the registration says of itself, so that it is not lost on the way: a doubt is a field of its own
/// name.
void write_report(const Registration& registration, NamedArrays& fields) {
  fields["residual_mm"] = number(1e3 * registration.residual);
  fields["seen_share"] = number(registration.seen_share);
  fields["converged"] = number(registration.termination == Termination::converged ? 1.0 : 0.0);
  fields[kTermination + termination_code(registration.termination)] = number(1.0);
  for (const std::string& doubt : registration.doubts) {
    std::istringstream words(doubt);
    std::string code;
    words >> code;
    std::vector<double> values;
    for (double value = 0.0; words >> value;) values.push_back(value);
    fields[kDoubt + code] = values.empty() ? number(1.0)
                                           : Eigen::MatrixXd(Eigen::Map<const Eigen::RowVectorXd>(
                                                 values.data(), static_cast<Eigen::Index>(values.size())));
  }
  for (const LesionSpread& spread : registration.lesions)
    fields[structure_name(spread.lesion) + kCovariance] = 1e6 * spread.covariance;
  for (const ForkSpread& fork : registration.forks) {
    fields[fork_name(fork) + kCovariance] = 1e6 * fork.covariance;
    Eigen::RowVector4d place;
    place << 1e3 * fork.centre.transpose(), 1e3 * fork.radius;
    fields[fork_name(fork) + kFork] = place;
  }
}

/// @throws InputError it is no covariance.
Eigen::Matrix3d covariance_of(const fs::path& path, const std::string& name, const Eigen::MatrixXd& values) {
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Constant(std::numeric_limits<double>::quiet_NaN());
  if (values.size() == 9)  // symmetric: rows or columns, 3 x 3 or one row of 9
    covariance = 1e-6 * Eigen::Map<const Eigen::Matrix3d>(Eigen::MatrixXd(values).data());
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(covariance, Eigen::EigenvaluesOnly);
  const bool is_one = covariance.allFinite() && covariance.isApprox(covariance.transpose(), 1e-6) &&
                      eigen.eigenvalues()[0] >= -1e-6 * eigen.eigenvalues()[2];
  if (!is_one)
    throw InputError(path.string(), name, "is no covariance",
                     "Give 3 x 3 numbers, symmetric and without negative variances, or leave it out");
  return covariance;
}

/// Of lesions that are not in it nothing is known.
std::vector<LesionSpread> read_spreads(const fs::path& path, const NamedArrays& fields) {
  std::vector<LesionSpread> spreads;
  for (const auto& [name, array] : fields) {
    if (!name.ends_with(kCovariance)) continue;
    const auto label = structure_named(name.substr(0, name.size() - kCovariance.size()));
    if (label && is_lesion(*label)) spreads.push_back({*label, covariance_of(path, name, array)});
  }
  return spreads;
}

/// In the order of tree and size. @throws InputError covariance or place is none.
std::vector<ForkSpread> read_forks(const fs::path& path, const NamedArrays& fields) {
  std::vector<ForkSpread> forks;
  for (const auto& [name, array] : fields) {
    if (!name.ends_with(kFork)) continue;
    const std::string fork = name.substr(0, name.size() - kFork.size());
    const auto named = fork_named(fork);
    const auto covariance = fields.find(fork + kCovariance);
    if (!named || covariance == fields.end()) continue;
    if (array.size() != 4 || !array.allFinite())
      throw InputError(path.string(), name, "is not a place and a radius",
                       "Write it as 'glisson register' does, or leave it out");
    const auto values = array.reshaped();
    forks.push_back({named->first, named->second, 1e-3 * values[3], 1e-3 * values.head<3>(),
                     covariance_of(path, covariance->first, covariance->second)});
  }
  std::sort(forks.begin(), forks.end(), [](const ForkSpread& a, const ForkSpread& b) {
    return std::pair(a.tree, a.order) < std::pair(b.tree, b.order);
  });
  return forks;
}

const std::string kExpected = "expected_error_mm", kNodeCovariance = "covariance_mm2",
                  kForce = "force_n_per_kpa", kRival = "rival_", kDisplacement = "_displacement_mm",
                  kProbability = "_probability", kSeen = "_expected_error_after_look_mm",
                  kLooks = "_looks_mm";  ///< behind a lesion's name: now, margin marked, notch marked

/// What the registration knows of each node: its expected error, the force that acts there, and how far it
/// is to where it may be as well.
void write_places(const Registration& registration, TetFile& file) {
  if (registration.expected.size() > 0) file.point_data[kExpected] = 1e3 * registration.expected;
  if (registration.covariances.rows() > 0) file.point_data[kNodeCovariance] = 1e6 * registration.covariances;
  if (!registration.forces.empty()) {
    Eigen::MatrixXd forces = Eigen::MatrixXd::Zero(registration.nodes_in_camera.rows(), 3);
    for (const FoundForce& force : registration.forces) forces.row(force.node) = force.force.transpose();
    file.point_data[kForce] = forces;
  }
  for (const LesionLooks& looks : registration.looks) {
    const std::string name = structure_name(looks.lesion);
    file.point_data[name + kSeen] = 1e3 * looks.seen;
    file.field_data[name + kLooks] = 1e3 * Eigen::RowVector3d(looks.now, looks.margin, looks.notch);
  }
  for (std::size_t k = 0; k < registration.rivals.size(); ++k) {
    const RegistrationRival& rival = registration.rivals[k];
    const std::string name = kRival + std::to_string(k + 1);
    file.point_data[name + kDisplacement] = 1e3 * (rival.nodes_in_camera - registration.nodes_in_camera);
    file.field_data[name + kProbability] = number(rival.probability);
  }
}

/// @return of this many columns, one row a node; null: it is not there.
const Eigen::MatrixXd* node_array(const fs::path& path, const TetFile& file, const std::string& name,
                                  Eigen::Index columns) {
  const auto found = file.point_data.find(name);
  if (found == file.point_data.end()) return nullptr;
  if (found->second.rows() != file.mesh.vertex_count() || found->second.cols() != columns ||
      !found->second.allFinite())
    throw InputError(path.string(), name, "is not " + std::to_string(columns) + " finite numbers a node",
                     "Write it as 'glisson register' does, or leave it out");
  return &found->second;
}

/// What a look would tell of lesions that it is known of.
std::vector<LesionLooks> read_looks(const fs::path& path, const TetFile& file) {
  std::vector<LesionLooks> all;
  for (const auto& [name, array] : file.field_data) {
    if (!name.ends_with(kLooks)) continue;
    const std::string lesion = name.substr(0, name.size() - kLooks.size());
    const auto label = structure_named(lesion);
    const Eigen::MatrixXd* seen = node_array(path, file, lesion + kSeen, 1);
    if (!label || !is_lesion(*label) || seen == nullptr) continue;
    if (array.size() != 3 || !array.allFinite() || array.minCoeff() < 0.0 || seen->minCoeff() < 0.0)
      throw InputError(path.string(), name, "is not 3 lengths, or those of the nodes are none",
                       "Write it as 'glisson register' does, or leave both out");
    const auto values = array.reshaped();
    all.push_back({*label, 1e-3 * values[0], 1e-3 * *seen, 1e-3 * values[1], 1e-3 * values[2]});
  }
  return all;
}

void read_places(const fs::path& path, const TetFile& file, Registration& registration) {
  if (const Eigen::MatrixXd* expected = node_array(path, file, kExpected, 1)) {
    if (expected->minCoeff() < 0.0)
      throw InputError(path.string(), kExpected, "is negative", "Give lengths, or leave it out");
    registration.expected = 1e-3 * *expected;
  }
  if (const Eigen::MatrixXd* covariances = node_array(path, file, kNodeCovariance, 6)) {
    if (covariances->leftCols<3>().minCoeff() < 0.0)
      throw InputError(path.string(), kNodeCovariance, "holds a negative variance",
                       "Write it as 'glisson register' does, or leave it out");
    registration.covariances = 1e-6 * *covariances;
  }
  if (const Eigen::MatrixXd* forces = node_array(path, file, kForce, 3)) {
    for (int node = 0; node < file.mesh.vertex_count(); ++node)
      if (!forces->row(node).isZero(0.0))
        registration.forces.push_back({node, forces->row(node).transpose()});
    std::stable_sort(registration.forces.begin(), registration.forces.end(),
                     [](const auto& a, const auto& b) { return a.force.norm() > b.force.norm(); });
  }
  for (int k = 1;; ++k) {
    const std::string name = kRival + std::to_string(k);
    const Eigen::MatrixXd* away = node_array(path, file, name + kDisplacement, 3);
    if (away == nullptr) return;
    const auto probability = file.field_data.find(name + kProbability);
    const bool is_one = probability != file.field_data.end() && probability->second.size() == 1 &&
                        probability->second(0, 0) >= 0.0 && probability->second(0, 0) <= 1.0;
    if (!is_one)
      throw InputError(path.string(), name + kProbability, "is no probability",
                       "Give a number from 0 to 1, or leave the rival out");
    registration.rivals.push_back({file.mesh.vertices + 1e-3 * *away, probability->second(0, 0)});
  }
}

std::string doubt_of(const std::string& code, const Eigen::MatrixXd& values) {
  std::ostringstream doubt;
  doubt << code;
  if (values.size() > 1)
    for (Eigen::Index k = 0; k < values.size(); ++k) doubt << ' ' << values.reshaped()[k];
  return doubt.str();
}

/// Files of before, and of other writers, say whether it converged at most.
Termination read_termination(const NamedArrays& fields, bool has_converged) {
  for (const auto& [termination, code] : kTerminations)
    if (fields.contains(kTermination + code)) return termination;
  return has_converged ? Termination::converged : Termination::step_limit;
}

/// What other writers leave out keeps its default.
void read_report(const NamedArrays& fields, Registration& registration) {
  const auto value = [&](const char* name, double otherwise) {
    const auto found = fields.find(name);
    return found != fields.end() && found->second.size() == 1 ? found->second(0, 0) : otherwise;
  };
  registration.residual = 1e-3 * value("residual_mm", 0.0);
  registration.seen_share = value("seen_share", 0.0);
  registration.termination = read_termination(fields, value("converged", 1.0) != 0.0);
  for (const auto& [name, array] : fields)
    if (name.starts_with(kDoubt)) registration.doubts.push_back(doubt_of(name.substr(kDoubt.size()), array));
}

}  // namespace

void write_registration(const fs::path& path, const PatientModel& model, const Registration& registration,
                        LengthUnit unit, const NamedArrays& said) {
  TetFile file;
  file.field_data = said;
  file.mesh = model.mesh;
  file.mesh.vertices = registration.nodes_in_camera;
  Eigen::Matrix4d matrix = registration.camera_from_ct.matrix();
  matrix.topRightCorner<3, 1>() /= metres_per(unit);
  file.field_data["cloud_from_model"] = matrix;
  write_report(registration, file.field_data);
  file.point_data[std::string("displacement_") + unit_code(unit)] =
      (registration.nodes_in_camera - registration.camera_from_ct.apply(model.mesh.vertices)) /
      metres_per(unit);
  write_places(registration, file);
  write_tet_mesh(path, file, unit);
}

Registration read_registration(const fs::path& path, const PatientModel& model, LengthUnit unit) {
  const TetFile file = read_tet_file(path, unit);
  if (file.mesh.vertex_count() != model.mesh.vertex_count() || file.mesh.tetrahedra != model.mesh.tetrahedra)
    throw InputError(path.string(), "mesh",
                     "is not this model's (" + std::to_string(file.mesh.vertex_count()) +
                         " nodes, the model has " + std::to_string(model.mesh.vertex_count()) + ")",
                     "Give the file that 'glisson register' wrote for this model");
  Registration registration;
  registration.nodes_in_camera = file.mesh.vertices;
  read_report(file.field_data, registration);
  registration.lesions = read_spreads(path, file.field_data);
  registration.forks = read_forks(path, file.field_data);
  registration.looks = read_looks(path, file);
  read_places(path, file, registration);
  const auto rigid = file.field_data.find("cloud_from_model");
  if (rigid != file.field_data.end() && rigid->second.size() == 16) {
    // Field data is a table of tuples: 4 x 4 as written, or one row of 16 from other writers.
    Eigen::Matrix4d matrix;
    for (int i = 0; i < 4; ++i)
      for (int k = 0; k < 4; ++k)
        matrix(i, k) = rigid->second.rows() == 4 ? rigid->second(i, k) : rigid->second(0, 4 * i + k);
    matrix.topRightCorner<3, 1>() *= metres_per(unit);
    registration.camera_from_ct = CameraFromCt::from_matrix(matrix);
  } else {
    registration.camera_from_ct = fit_rigid<CameraFrame, CtFrame>(model.mesh.vertices, file.mesh.vertices);
  }
  return registration;
}

bool or_lost(const CaseFolder& folder, const char* code, const std::function<void()>& read) {
  try {
    read();
    return true;
  } catch (const Error& failure) {
    if (folder.lost == nullptr) throw;
    folder.lost->push_back(std::string(code) + ' ' + failure.what());
    return false;
  } catch (const json::exception&) {
    const InputError failure((folder.path / "case.json").string(), code, "is malformed",
                             "Restore the case from a copy, or make this part anew");
    if (folder.lost == nullptr) throw failure;
    folder.lost->push_back(std::string(code) + ' ' + failure.what());
    return false;
  }
}

}  // namespace glisson::engine
