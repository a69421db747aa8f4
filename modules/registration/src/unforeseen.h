// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <vector>

#include "glisson/core/run_context.h"
#include "glisson/fem/elastic_body.h"
#include "glisson/patient/patient_model.h"
#include "glisson/registration/operation_prior.h"

namespace glisson::registration {

/// Forces that nobody has simulated (tools, contacts, ligaments cut), anywhere on the surface.
struct Unforeseen {
  double motion = kUnforeseenMotion;            ///< that they cause, of a node, rms, m
  double patch_spacing = 25e-3;                 ///< of their places, m
  double patch_radius = kUnforeseenSpread;      ///< over which one spreads, m
  std::vector<int> fixed_nodes;                 ///< known to stay
  std::vector<double> stiffness;                ///< of each tetrahedron over the parenchyma's; empty: all 1
  int modes = std::numeric_limits<int>::max();  ///< principal components kept, at most
};

/// The principal components of what such forces do to a linear body, one standard deviation each, the largest
/// first. Independent forces of one size in every patch and direction; where no node is fixed soft springs to
/// the ground hold the body and its rigid motion is left out: the pose is sought for itself.
/// Shape: 3 N x K, CT frame, m; no columns where the body cannot be held.
/// Cancelled: no columns.
fem::NodalColumns unforeseen_motions(const PatientModel& model, const Unforeseen& forces,
                                     const RunContext& context = {});

}  // namespace glisson::registration
