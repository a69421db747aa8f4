// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glisson/core/run_context.h"
#include "glisson/patient/labelled_cloud.h"
#include "glisson/patient/patient_model.h"
#include "rigid.h"
#include "shape_fits.h"

/// @file
/// Several looks at one organ: clouds of a laparoscope that has moved, each in its own left camera's frame,
/// while the organ has not. Where each was seen from is not known; it is found together with the organ's
/// shape.

namespace glisson::registration {

/// One cloud of all looks, in the first one's camera frame. Normals and deviations are kept where all have
/// them. @param into_first from each look's camera into the first one's; the first is the identity.
/// @pre as many motions as looks, one at least. @throws InputError a look of fewer than ten points.
LabelledCloud joined(const std::vector<LabelledCloud>& looks, const LookMotions& into_first);

/// One motion for each look of a cloud, none for a cloud of one look; those that are not given are none.
LookMotions one_a_look(const LabelledCloud& cloud, LookMotions given);
/// `still` with its looks moved, into `moved` (points, normals, eyes). @pre a motion each.
void move_looks(const LabelledCloud& still, const LookMotions& motions, LabelledCloud& moved);

/// Looks as they were put together, and where else each of them may have been seen from.
struct JoinedLooks {
  LabelledCloud cloud;
  LookMotions into_first;          ///< as `cloud` has them
  std::vector<ShapeStart> starts;  ///< for the shapes, the likeliest first; motions of `cloud`
};
/// Places each further look by laying it onto the model on its own (align_rigid), so that looks that share
/// nothing of the organ can be joined, too. Starts: all of the first look's with the likeliest of the others,
/// and the likeliest of the first with other places of the others.
/// @param first where the model is before the first look's camera. @throws InputError as align_rigid.
Cancellable<JoinedLooks> join_looks(const PatientModel& model, const LabelledCloud& cloud,
                                    const std::vector<LabelledCloud>& others, const RigidStart& first,
                                    const RigidOptions& options, const RunContext& context);

/// Logarithm of the odds that all looks show one shape, against each of them showing another: what an organ
/// that has moved or been bent in between amounts to. The fits of single looks begin where the joint one has
/// put the organ. @param looks and into_first as for joined(); joint a fit of what it gave.
Cancellable<double> one_shape_odds(const PatientModel& model, const OperationPrior& prior,
                                   const std::vector<LabelledCloud>& looks, const LookMotions& into_first,
                                   const ShapeFit& joint, const ShapeFitOptions& options,
                                   const RunContext& context);

/// How far each look lies from the registered surface: mean distance of its nearer nine tenths, metres.
std::vector<double> distances_of_looks(const PatientModel& model, const PointsIn<CameraFrame>& nodes,
                                       const LabelledCloud& cloud);

}  // namespace glisson::registration
