// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "glisson/ui/common/couplings.h"
#include "glisson/ui/guidance/registration_model.h"

namespace glisson::ui {

/// Registers the model to the labelled points, and says how that went.
class RegistrationBox : public QWidget {
  Q_OBJECT
 public:
  /// @param model outlives the box.
  RegistrationBox(EngineBridge& engine, RegistrationModel& model, QWidget* parent = nullptr);

 private:
  Couplings couplings_;
};

}  // namespace glisson::ui
