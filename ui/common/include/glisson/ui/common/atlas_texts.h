// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "glisson/atlas/transfer.h"
#include "glisson/engine/case_state.h"

namespace glisson::ui {

/// "Umbilical notch" for "umbilical_notch"; empty for what is no landmark.
QString landmark_text(const QString& code);
QString landmark_text(atlas::Structure structure);
/// Why a proposal lies where it lies: "found in the CT", "from 22 livers, 9 mm".
QString reason_text(const atlas::Proposal& proposal);
/// And on a second line that a person's own mark is used instead, where one stands there.
QString reasons_text(const engine::CaseState& state, const atlas::Proposal& proposal);
QString decision_text(atlas::Decision decision);

}  // namespace glisson::ui
