// SPDX-License-Identifier: GPL-3.0-or-later
// A registration as a mesh: the nodes where it puts them, and in point and field data what is known of it.
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>
#include <sstream>
#include <utility>

#include "glisson/core/error.h"
#include "glisson/engine/case_io.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/geometry/rigid.h"
#include "glisson/patient/label_map.h"
#include "glisson/registration/refusal.h"
#include "glisson/registration/registration_files.h"

namespace glisson::engine {
namespace fs = std::filesystem;

namespace {

const std::string kDoubt = "doubt_";
const std::string kDoubts = "doubts";               ///< how many
const std::string kNote = "note_";                  ///< before its text, which may hold words
constexpr double kNoValue = -1.0;                   ///< of a doubt: values are not negative
const std::string kTermination = "termination_";    ///< before its code
const std::string kCovariance = "_covariance_mm2";  ///< behind a lesion's or a fork's name
const std::string kFork = "_centre_radius_mm";      ///< behind a fork's name

Eigen::MatrixXd number(double value) { return Eigen::MatrixXd::Constant(1, 1, value); }

}  // namespace

NamedArrays registration_fields(const Registration& registration, const NamedArrays& said) {
  NamedArrays fields;
  fields["residual_mm"] = number(1e3 * registration.residual);
  fields["seen_share"] = number(registration.seen_share);
  fields["converged"] = number(registration.termination == Termination::converged ? 1.0 : 0.0);
  fields[kTermination + termination_code(registration.termination)] = number(1.0);
  fields[kDoubts] = number(static_cast<double>(registration.doubts.size()));
  for (const std::string& doubt : registration.doubts) {
    std::istringstream words(doubt);
    std::string code;
    words >> code;
    std::vector<double> values;
    for (double value = 0.0; words >> value;) values.push_back(value);
    fields[kDoubt + code] = values.empty() ? number(kNoValue)
                                           : Eigen::MatrixXd(Eigen::Map<const Eigen::RowVectorXd>(
                                                 values.data(), static_cast<Eigen::Index>(values.size())));
  }
  for (const std::string& note : registration.notes) fields[kNote + note] = number(1.0);
  for (const LesionSpread& spread : registration.lesions)
    fields[structure_name(spread.lesion) + kCovariance] = 1e6 * spread.covariance;
  for (const ForkSpread& fork : registration.forks) {
    fields[fork_name(fork) + kCovariance] = 1e6 * fork.covariance;
    Eigen::RowVector4d place;
    place << 1e3 * fork.centre.transpose(), 1e3 * fork.radius;
    fields[fork_name(fork) + kFork] = place;
  }
  for (const auto& [name, array] : said) fields[name] = array;
  return fields;
}

namespace {

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
    // Patches of different sizes may have one middle: their forces act together.
    for (const FoundForce& force : registration.forces) forces.row(force.node) += force.force.transpose();
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

/// @param no_value what says that a doubt has none.
std::string doubt_of(const std::string& code, const Eigen::MatrixXd& values, double no_value) {
  std::ostringstream doubt;
  doubt << code;
  if (values.size() > 1 || values.reshaped()[0] != no_value)
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
  const double no_value = fields.contains(kDoubts) ? kNoValue : 1.0;  // 1 in files of before
  for (const auto& [name, array] : fields)
    if (name.starts_with(kDoubt) && array.size() > 0)
      registration.doubts.push_back(doubt_of(name.substr(kDoubt.size()), array, no_value));
    else if (name.starts_with(kNote))
      registration.notes.push_back(name.substr(kNote.size()));
}

}  // namespace

void write_registration(const fs::path& path, const PatientModel& model, const Registration& registration,
                        LengthUnit unit, const NamedArrays& said) {
  TetFile file;
  file.field_data = registration_fields(registration, said);
  file.mesh = model.mesh;
  file.mesh.vertices = registration.nodes_in_camera;
  Eigen::Matrix4d matrix = registration.camera_from_ct.matrix();
  matrix.topRightCorner<3, 1>() /= metres_per(unit);
  file.field_data["cloud_from_model"] = matrix;
  file.point_data[std::string("displacement_") + unit_code(unit)] =
      (registration.nodes_in_camera - registration.camera_from_ct.apply(model.mesh.vertices)) /
      metres_per(unit);
  write_places(registration, file);
  write_tet_mesh(path, file, unit);
}

namespace {

/// Field data is a table of tuples: 4 x 4 as written; one row or one column of 16 from other writers.
CameraFromCt read_rigid(const fs::path& path, const Eigen::MatrixXd& table, LengthUnit unit) {
  const bool is_square = table.rows() == 4 && table.cols() == 4;
  if (!is_square && !(table.size() == 16 && (table.rows() == 1 || table.cols() == 1)))
    throw InputError(path.string(), "cloud_from_model", "is not 16 numbers",
                     "Write a 4 x 4 matrix, cloud_from_model, row by row");
  Eigen::Matrix4d matrix;
  for (Eigen::Index i = 0; i < 4; ++i)
    for (Eigen::Index k = 0; k < 4; ++k) {
      const Eigen::Index n = 4 * i + k;
      matrix(i, k) = is_square ? table(i, k) : table.rows() == 1 ? table(0, n) : table(n, 0);
    }
  return registration::camera_from_ct_of(matrix, unit, path.string());
}

}  // namespace

Registration read_registration(const fs::path& path, const PatientModel& model, LengthUnit unit) {
  const TetFile file = read_tet_file(path, unit, MeshShape::deformed);
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
  registration.camera_from_ct = rigid != file.field_data.end() ? read_rigid(path, rigid->second, unit)
                                                               : fit_rigid<CameraFrame, CtFrame>(
                                                                     model.mesh.vertices, file.mesh.vertices);
  return registration;
}

}  // namespace glisson::engine
