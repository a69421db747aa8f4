// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <future>

#include "glisson/core/run_context.h"
#include "glisson/registration/register_model.h"

namespace glisson::registration {

/// A control: the cloud's mirror image goes the way from the rigid start to the most probable shape again. A
/// liver is not symmetric, so that no organ explains it (see EVIDENCE.md).
class MirrorControl {
 public:
  /// Computes the cost on a thread of its own. @param model is to live as long as this object.
  /// @pre `elastic` has a prior.
  void begin_beside(const PatientModel& model, const LabelledCloud& cloud, const RegisterOptions& options,
                    const ElasticOptions& elastic, const RunContext& context);
  bool has_begun() const { return cost_.valid(); }
  /// What the most probable shape costs (ShapeFit::cost): what begin_beside() has found, else found now.
  /// Empty: cancelled.
  Cancellable<double> cost(const PatientModel& model, const LabelledCloud& cloud,
                           const RegisterOptions& options, const ElasticOptions& elastic,
                           const RunContext& context);

 private:
  std::future<Cancellable<double>> cost_;
};

}  // namespace glisson::registration
