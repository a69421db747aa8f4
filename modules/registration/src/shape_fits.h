// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "glisson/core/run_context.h"
#include "glisson/patient/labelled_cloud.h"
#include "glisson/patient/patient_model.h"
#include "glisson/patient/registration.h"
#include "glisson/registration/operation_prior.h"
#include "glisson/registration/shape_fit.h"

namespace glisson::registration {

/// Where a fit begins.
struct ShapeStart {
  CameraFromCt camera_from_ct;
  LookMotions looks;
};

/// Where the organ most probably is, given the cloud and what operations do.
struct ShapeFit {
  CameraFromCt camera_from_ct;
  Eigen::VectorXd amplitudes;  ///< of the prior's modes, standard deviations
  Points nodes_in_camera;
  double residual = 0.0;  ///< mean distance over the pairs kept, metres
  /// Twice the negative logarithm of the posterior, but for a constant: robust squared distances in standard
  /// deviations (a point without a pair counts as a far one) and squared amplitudes. Compares fits of one
  /// cloud.
  double cost = 0.0;
  /// Logarithm of how probable the cloud is, whatever shape and poses are, but for constants of a point and
  /// of a pose (Laplace). Compares what shares out the same points and poses otherwise.
  double log_evidence = 0.0;
  int iterations = 0;
  ShapeStart start;   ///< where it was begun
  LookMotions looks;  ///< of the cloud; empty: it is of one look
};

/// Maximum a posteriori of pose, amplitudes and where further looks were seen from, together: closest points
/// (label-restricted, on the fine surface, which may slide along it freely), Gauss and Newton, Cauchy's
/// robust weight, the prior's amplitudes standard normal.
/// @throws InputError the cloud's as in prepare_cloud; options.
Cancellable<ShapeFit> fit_shape(const PatientModel& model, const OperationPrior& prior,
                                const LabelledCloud& cloud, const ShapeStart& start,
                                const ShapeFitOptions& options, const RunContext& context);

/// The fits from all starts, the most probable first.
struct ShapeFits {
  std::vector<ShapeFit> fits;
  /// shape_ambiguous (another shape, 10 mm away on average and more, is nearly as probable), shape_unusual
  /// (an amplitude beyond four standard deviations).
  std::vector<std::string> doubts;
  const ShapeFit& best() const { return fits.front(); }
  /// One of each place that the shapes have ended in, the most probable first; without those that are out of
  /// question.
  std::vector<const ShapeFit*> places() const;
};
/// The likeliest pose first; looks as the cloud has them.
std::vector<ShapeStart> starts_of(const CameraFromCt& best, const std::vector<CameraFromCt>& others);
/// The fits from several starts. @pre one at least. @throws as fit_shape.
Cancellable<ShapeFits> fit_shapes(const PatientModel& model, const OperationPrior& prior,
                                  const LabelledCloud& cloud, const std::vector<ShapeStart>& starts,
                                  const ShapeFitOptions& options, const RunContext& context);

}  // namespace glisson::registration
