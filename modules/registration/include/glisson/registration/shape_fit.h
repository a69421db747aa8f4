// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "glisson/patient/labelled_cloud.h"
#include "glisson/patient/registration.h"
#include "glisson/registration/operation_prior.h"

namespace glisson::registration {

/// How far the cloud is believed when the most probable shape is looked for.
struct ShapeFitOptions {
  /// Standard deviations, metres: of a surface point across the surface (the reconstruction's noise and the
  /// segmentation's), of a margin point, of the notch as a whole.
  double sigma_surface = 3e-3, sigma_margin = 6e-3, sigma_notch = 3e-3;
  /// Independent information in what the reference density's one point stands for: neighbouring points share
  /// the error of the model's surface, they do not average it away. In (0, 1].
  double information = 0.2;
  int max_iterations = 80;
  int threads = 2;  ///< 1 or 2, for several fits: the same bits
  /// @throws InputError naming the option.
  void validate() const;
};

/// How each look of a joined cloud (looks.h) is moved before it agrees with the first, which stays. Empty: as
/// the cloud has them.
using LookMotions = std::vector<Rigid<CameraFrame, CameraFrame>>;

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

}  // namespace glisson::registration
