// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/registration/registration_files.h"

#include <Eigen/Core>
#include <sstream>
#include <string>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/core/patient_range.h"
#include "glisson/geometry/mesh_io.h"

namespace glisson::registration {
namespace fs = std::filesystem;

namespace {

constexpr const char* kRemedy = "Write a 4 x 4 matrix, cloud_from_model, row by row";

}  // namespace

CameraFromCt camera_from_ct_of(Eigen::Matrix4d matrix, LengthUnit unit, const std::string& where) {
  constexpr double kRounded = 1e-3;
  if (!matrix.row(3).isApprox(Eigen::RowVector4d(0.0, 0.0, 0.0, 1.0), kRounded))
    throw InputError(where, "matrix", "its last row is not 0 0 0 1", kRemedy);
  matrix.topRightCorner<3, 1>() *= metres_per(unit);
  if (matrix.topRightCorner<3, 1>().cwiseAbs().maxCoeff() > kPatientRange)
    throw InputError(where, "matrix", "is nowhere near a patient", kRemedy);
  return CameraFromCt::from_matrix(matrix, where);
}

CameraFromCt read_start(const fs::path& path, LengthUnit unit) {
  std::istringstream stream(read_file(path));
  Eigen::Matrix4d matrix;
  for (int i = 0; i < 16; ++i)
    if (!(stream >> matrix(i / 4, i % 4)))
      throw InputError(path.string(), "matrix", "is not 16 numbers", kRemedy);
  if (std::string more; stream >> more)
    throw InputError(path.string(), "matrix", "is not 16 numbers", kRemedy);
  return camera_from_ct_of(matrix, unit, path.string());
}

void write_carried_surface(const fs::path& path, const TriangleMesh& surface, const PatientModel& model,
                           const Registration& registration, LengthUnit unit, const NamedArrays& said) {
  TriangleFile file;
  file.mesh = surface;
  const Binding binding = bind_points(model.mesh, surface.vertices, false);
  file.mesh.vertices = binding.apply(model.mesh, registration.nodes_in_camera);
  if (registration.expected.size() > 0)
    file.point_data["expected_error_mm"] =
        1e3 * binding.apply(model.mesh, registration.expected.replicate<1, 3>()).col(0).cwiseMax(0.0);
  Eigen::Matrix4d matrix = registration.camera_from_ct.matrix();
  matrix.topRightCorner<3, 1>() /= metres_per(unit);
  file.field_data = said;
  file.field_data["cloud_from_model"] = matrix;
  write_triangle_mesh(path, file, unit);
}

}  // namespace glisson::registration
