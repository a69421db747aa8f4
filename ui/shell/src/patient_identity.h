// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>

#include "glisson/engine/case_state.h"

namespace glisson::ui {

/// Whose case is open, in every step: name, ID and birth date as the CT's header has them, or that they are
/// not known. Plain text, and cut where it is long; the tool tip has all.
class PatientIdentity : public QLabel {
  Q_OBJECT
 public:
  explicit PatientIdentity(QWidget* parent = nullptr);
  void show_case(const engine::CaseState& state);
};

}  // namespace glisson::ui
