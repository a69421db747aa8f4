// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "glisson/ui/common/couplings.h"
#include "glisson/ui/guidance/placing_model.h"
#include "glisson/ui/guidance/registration_model.h"

namespace glisson::ui {

/// Registers the model to the labelled points, says how that went, lets a person choose among places, and
/// start from where a hand has put the organ.
class RegistrationBox : public QWidget {
  Q_OBJECT
 public:
  /// The models outlive the box.
  RegistrationBox(EngineBridge& engine, RegistrationModel& model, PlacingModel& placing,
                  QWidget* parent = nullptr);

 private:
  QLayout* make_method_row(RegistrationModel& model);
  QWidget* make_undo(RegistrationModel& model);
  QWidget* make_rival_rows(EngineBridge& engine, RegistrationModel& model);
  QWidget* make_placing_rows(EngineBridge& engine, RegistrationModel& model, PlacingModel& placing);

  Couplings couplings_;
};

}  // namespace glisson::ui
