// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "glisson/atlas/transfer.h"

namespace glisson::ui {

/// "Umbilical notch" for "umbilical_notch"; empty for what is no landmark.
QString landmark_text(const QString& code);
QString landmark_text(atlas::Structure structure);
/// Why a proposal lies where it lies: "found in the CT", "from 22 livers, 9 mm".
QString reason_text(const atlas::Proposal& proposal);
QString decision_text(atlas::Decision decision);

}  // namespace glisson::ui
