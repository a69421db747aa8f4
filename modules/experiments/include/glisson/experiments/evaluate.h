// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "glisson/core/json_file.h"
#include "glisson/core/units.h"
#include "glisson/geometry/camera.h"
#include "glisson/patient/labelled_cloud.h"
#include "glisson/patient/patient_model.h"

/// @file
/// Comparison with the truth. Nothing but these functions reads it, and they run after the last stage.

namespace glisson::experiments {

/// Target registration errors of an estimate against the true positions of the same nodes (one frame,
/// metres): all nodes (`tre_volume_mean_mm`, `tre_volume_max_mm`), the surface's (`tre_surface_mean_mm`,
/// `tre_surface_max_mm`), the lesions' centres carried by their tetrahedra (`tre_target_mean_mm`,
/// `tre_target_max_mm`; not a number without lesions).
/// @throws InputError (file = `name`) when the truth has another number of nodes.
Figures target_errors(const PatientModel& model, const Points& estimated_nodes, const Points& true_nodes,
                      const std::string& name);

/// What the best rigid motion of the undeformed model leaves (`rigid_best_mean_mm`: the elastic part of the
/// motion) and how far it moved (`motion_mean_mm`, from `start`, which may be the undeformed model itself or
/// its rigid start).
Figures motion_figures(const PatientModel& model, const Points& start_nodes, const Points& true_nodes);

/// The true positions of lesion centres against the estimate's. Rows correspond. Metres.
Figures lesion_errors(const PatientModel& model, const Points& estimated_nodes, const Points& true_centres);

/// True node positions: .xyz, or any mesh file with as many nodes. Metres.
/// @throws FileError; InputError as the reader of that format.
Points read_true_nodes(const std::filesystem::path& path, LengthUnit unit);

/// A cloud against the truth in a file: a surface in the left camera's frame, or that camera's depth map
/// (.pfm, millimetres): `cloud_error_median_mm`, `cloud_error_mean_mm`, `cloud_error_p95_mm`,
/// `cloud_bias_mm` (not numbers where no point has a truth), `cloud_points_without_truth`.
/// @param unit of a surface's file.
/// @throws FileError; InputError what cannot be read, a depth map of another size than the camera's pictures.
Figures cloud_figures(const LabelledCloud& cloud, const Camera& left, const std::filesystem::path& truth,
                      LengthUnit unit);

/// A model's surface against a fine one of the same organ: `surface_to_truth_mean_mm`,
/// `truth_to_surface_mean_mm`, `truth_to_surface_max_mm`.
Figures surface_figures(const TriangleMesh& surface, const TriangleMesh& truth);

}  // namespace glisson::experiments
