// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "glisson/ui/common/couplings.h"
#include "glisson/ui/guidance/mask_model.h"

namespace glisson::ui {

/// Chooses and removes the person's own mask network, and tells how it does.
class MaskBox : public QWidget {
  Q_OBJECT
 public:
  /// @param model outlives this.
  explicit MaskBox(MaskModel& model, QWidget* parent = nullptr);

 private:
  Couplings couplings_;
};

}  // namespace glisson::ui
