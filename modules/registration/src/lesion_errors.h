// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "glisson/patient/patient_model.h"
#include "glisson/patient/registration.h"
#include "glisson/registration/error_model.h"

namespace glisson::registration {

/// The lesions' middles, tied to the mesh.
struct BoundLesions {
  std::vector<Label> labels;
  Binding middles;
};

BoundLesions bound_lesions(const PatientModel& model);

/// What is expected at each, camera frame, metres.
std::vector<LesionError> lesions_of(const TetMesh& mesh, const BoundLesions& bound, const ErrorModel& error,
                                    const Registration& registration);

/// Each covariance with this expected error (m, one a node) instead of its own.
void sized_as(const Eigen::VectorXd& expected, SymmetricRows& covariances);

/// The same for lesions, at whose middles the nodes' errors are interpolated.
void size_lesions(const TetMesh& mesh, const BoundLesions& bound, const Eigen::VectorXd& expected,
                  std::vector<LesionError>& lesions);

/// Looks by the same measure as the lesions' errors; of a lesion whose error is not known there is none.
void size_looks(const std::vector<LesionError>& lesions, std::vector<LesionLooks>& looks);

}  // namespace glisson::registration
