// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "glisson/ui/common/couplings.h"
#include "glisson/ui/guidance/again_model.h"

namespace glisson::ui {

/// Begins and cancels another registration of the organ that is followed, and changes between it and the
/// former one.
class AgainBox : public QWidget {
  Q_OBJECT
 public:
  /// @param model outlives this.
  explicit AgainBox(AgainModel& model, QWidget* parent = nullptr);

 private:
  Couplings couplings_;
};

}  // namespace glisson::ui
