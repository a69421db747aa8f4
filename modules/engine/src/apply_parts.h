// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/engine/engine.h"

/// @file
/// One function a command, grouped by the room that does the work. Each copies the state, changes its own
/// parts and says its figures.

namespace glisson::engine {

Cancellable<Applied> apply_one(const CaseState& state, const ImportImage& command, const RunContext& context);
Cancellable<Applied> apply_one(const CaseState& state, const ListSeries& command, const RunContext& context);
Cancellable<Applied> apply_one(const CaseState& state, const ImportLabels& command,
                               const RunContext& context);
Cancellable<Applied> apply_one(const CaseState& state, const ExportLabels& command,
                               const RunContext& context);
Cancellable<Applied> apply_one(const CaseState& state, const EditLabels& command, const RunContext& context);
Cancellable<Applied> apply_one(const CaseState& state, const PreviewEdit& command, const RunContext& context);
Cancellable<Applied> apply_one(const CaseState& state, const UndoLabels& command, const RunContext& context);
Cancellable<Applied> apply_one(const CaseState& state, const RedoLabels& command, const RunContext& context);
Cancellable<Applied> apply_one(const CaseState& state, const SetReview& command, const RunContext& context);
Cancellable<Applied> apply_one(const CaseState& state, const SetSeeds& command, const RunContext& context);
Cancellable<Applied> apply_one(const CaseState& state, const Segment& command, const RunContext& context);
Cancellable<Applied> apply_one(const CaseState& state, const BuildModel& command, const RunContext& context);
Cancellable<Applied> apply_one(const CaseState& state, const ImportSurfaces& command,
                               const RunContext& context);
Cancellable<Applied> apply_one(const CaseState& state, const ImportMesh& command, const RunContext& context);
Cancellable<Applied> apply_one(const CaseState& state, const EditTrees& command, const RunContext& context);
Cancellable<Applied> apply_one(const CaseState& state, const CheckModel& command, const RunContext& context);
Cancellable<Applied> apply_one(const CaseState& state, const SetLandmarks& command,
                               const RunContext& context);

Cancellable<Applied> apply_one(const CaseState& state, const SetCalibration& command,
                               const RunContext& context);
Cancellable<Applied> apply_one(const CaseState& state, const CalibrateRig& command,
                               const RunContext& context);
Cancellable<Applied> apply_one(const CaseState& state, const LoadStereoPair& command,
                               const RunContext& context);
Cancellable<Applied> apply_one(const CaseState& state, const SetVideo& command, const RunContext& context);
Cancellable<Applied> apply_one(const CaseState& state, const LoadVideoFrame& command,
                               const RunContext& context);
Cancellable<Applied> apply_one(const CaseState& state, const SetRegions& command, const RunContext& context);
Cancellable<Applied> apply_one(const CaseState& state, const Reconstruct& command, const RunContext& context);
Cancellable<Applied> apply_one(const CaseState& state, const ImportCloud& command, const RunContext& context);
Cancellable<Applied> apply_one(const CaseState& state, const Register& command, const RunContext& context);
Cancellable<Applied> apply_one(const CaseState& state, const ImportRegistration& command,
                               const RunContext& context);

Cancellable<Applied> apply_one(const CaseState& state, const Simulate& command, const RunContext& context);

/// @throws InputError "there is no ... yet" with what to do first.
void require_part(const CaseState& state, Part part, const char* remedy);

}  // namespace glisson::engine
