// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "glisson/core/error.h"
#include "glisson/registration/contact_forces.h"

namespace glisson::registration {

/// A followed cloud shows something else than the organ: no tissue has the shape that explains it
/// (is_beyond_tissue()).
class ForeignCloud : public NumericalError {
 public:
  using NumericalError::NumericalError;
};

/// A series of clouds of one organ by contact forces (contact_forces.h). The first cloud chooses the law, and
/// a later one again where it tells laws apart better than all before: by a larger motion over its noise.
/// Each is fitted under that law from where the organ was, beginning with the stage whose noise explains how
/// far the new cloud lies from there. Forces are found anew for each cloud: nothing of an error is handed on
/// but the place where closest points are sought. Not thread-safe.
class ForceFollower {
 public:
  /// @param start where the model's rest shape is before the camera; stays where nodes are fixed or it is
  /// known. @throws InputError options, mesh, fixed nodes out of range.
  ForceFollower(const PatientModel& model, const CameraFromCt& start, const ContactForceOptions& options);
  ~ForceFollower();
  ForceFollower(ForceFollower&&) noexcept;
  ForceFollower& operator=(ForceFollower&&) noexcept;

  /// The next cloud, in the camera's frame. After a failure the next one is followed from the last that
  /// succeeded. @throws InputError fewer than 10 points, not finite; NumericalError when no law has an
  /// equilibrium; ForeignCloud.
  Cancellable<ContactForceFit> follow(const LabelledCloud& cloud, const RunContext& context);

  /// The next cloud is followed from where the organ was before the last one, as if that had not been.
  void forget_last();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace glisson::registration
