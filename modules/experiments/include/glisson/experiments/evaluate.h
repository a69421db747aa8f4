// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "glisson/core/json_file.h"
#include "glisson/patient/patient_model.h"

/// @file
/// Comparison with the truth. Nothing but these functions reads it, and they run after the last stage.

namespace glisson::experiments {

/// Target registration errors of an estimate against the true positions of the same nodes (one frame,
/// metres): all nodes
/// (`tre_volume_mean_mm`, `tre_volume_max_mm`), the surface's (`tre_surface_mean_mm`, `tre_surface_max_mm`),
/// the lesions' centres carried by their tetrahedra (`tre_target_mean_mm`, `tre_target_max_mm`; not a number
/// without lesions).
/// @throws InputError (file = `name`) when the truth has another number of nodes.
Figures target_errors(const PatientModel& model, const Points& estimated_nodes, const Points& true_nodes,
                      const std::string& name);

/// What the best rigid motion of the undeformed model leaves (`rigid_best_mean_mm`: the elastic part of the
/// motion) and how far it moved (`motion_mean_mm`, from `start`, which may be the undeformed model itself or
/// its rigid start).
Figures motion_figures(const PatientModel& model, const Points& start_nodes, const Points& true_nodes);

/// The true positions of lesion centres against the estimate's. Rows correspond. Metres.
Figures lesion_errors(const PatientModel& model, const Points& estimated_nodes, const Points& true_centres);

}  // namespace glisson::experiments
