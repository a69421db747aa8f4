// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glisson/registration/register.h"
#include "glisson/registration/shape_fit.h"

namespace glisson::registration {

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
/// @pre one start at least. @throws as fit_shape.
Cancellable<ShapeFits> fit_shapes(const PatientModel& model, const OperationPrior& prior,
                                  const LabelledCloud& cloud, const std::vector<ShapeStart>& starts,
                                  const ShapeFitOptions& options, const RunContext& context);

/// register_elastic from the most probable of shapes that were fitted before. A shape that would turn
/// elements inside out is taken back as far as needed, with the doubt shape_inverted.
/// @pre options.prior, which the shapes rest on.
Cancellable<Registration> register_elastic(const PatientModel& model, const LabelledCloud& cloud,
                                           const ShapeFits& shapes, const ElasticOptions& options,
                                           const RunContext& context);

}  // namespace glisson::registration
