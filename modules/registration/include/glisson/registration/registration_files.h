// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "glisson/core/units.h"
#include "glisson/geometry/mesh.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/geometry/rigid.h"
#include "glisson/patient/patient_model.h"
#include "glisson/patient/registration.h"

/// @file
/// What a registration is given and gives as files of their own.

namespace glisson::registration {

/// Of a matrix cloud_from_model as a file has it, row by row. @param unit of its translation.
/// @param where the file, for the error.
/// @throws InputError no rotation, or a last row that is not 0 0 0 1: written column by column it would be
/// the inverse rotation without a translation.
CameraFromCt camera_from_ct_of(Eigen::Matrix4d matrix, LengthUnit unit, const std::string& where);

/// A rigid start: 16 numbers, a 4 x 4 matrix cloud_from_model, row by row.
/// @param unit of its translation.
/// @throws FileError; InputError not 16 numbers, or as camera_from_ct_of.
CameraFromCt read_start(const std::filesystem::path& path, LengthUnit unit);

/// A surface of the model, carried by its tetrahedra to where the registration puts them, in its own order
/// and unit; with `cloud_from_model` (4 x 4, the rigid part) as field data and `expected_error_mm` at its
/// vertices, where the format holds them.
/// @param said more field data.
/// @param surface where the model is undeformed, metres.
/// @throws FileError.
void write_carried_surface(const std::filesystem::path& path, const TriangleMesh& surface,
                           const PatientModel& model, const Registration& registration, LengthUnit unit,
                           const NamedArrays& said = {});

}  // namespace glisson::registration
