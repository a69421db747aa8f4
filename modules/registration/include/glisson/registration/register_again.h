// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/registration/examined_registration.h"

namespace glisson::registration {

/// An organ registered once more, and whether that is better by evidence that neither has used.
struct RegisteredAgain {
  ExaminedRegistration examined;
  /// Median distance of tissue that was kept out of the fit from the registered surface, metres: of the
  /// former registration, and of this one.
  double former_gap = 0.0, gap = 0.0;
  int kept_out = 0;  ///< places
  /// Mean way of the nodes from the former registration, metres.
  double moved = 0.0;
  /// Not refused, no doubt that the former did not have, and nearer to what was kept out by more than two
  /// standard deviations of the mean over its cubes.
  bool is_better = false;
};

/// Registers a model again with what has been seen of the organ since: the cloud of the first registration,
/// its marks included, and tissue seen later, in one fit. Every fifth place (cubes of 15 mm, so that no
/// neighbour tells of it) is kept out of the fit. The start is sought near the former one; with fixed nodes
/// it is the former one.
/// @param cloud of the first registration; empty: there is none.
/// @param tissue all looks joined in the moment and frame of that cloud: left camera, metres. Its surface
///   shows its face to where each place was seen from (`seen_from`).
/// @param options as for register_model; their start is not used.
/// @throws InputError fewer than 30 places of tissue, `former` is not of this model; as register_model.
Cancellable<RegisteredAgain> register_again(const PatientModel& model, const LabelledCloud& cloud,
                                            const LabelledCloud& tissue, const Registration& former,
                                            RegisterOptions options, const RunContext& context,
                                            const KnownOperations& known = {});

}  // namespace glisson::registration
