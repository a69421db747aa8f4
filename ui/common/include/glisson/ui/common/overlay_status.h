// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/engine/case_state.h"
#include "glisson/engine/parts/moments.h"
#include "glisson/ui/scene/overlay_painter.h"

namespace glisson::ui {

/// What an overlay's picture says of the case: whether its model was looked at, and how far the review of its
/// landmarks has come.
scene::OverlayStatus overlay_status(const engine::CaseState& state);
/// The same as it was when a moment was kept; it stands.
scene::OverlayStatus overlay_status(const engine::KeptMoment& moment);

}  // namespace glisson::ui
