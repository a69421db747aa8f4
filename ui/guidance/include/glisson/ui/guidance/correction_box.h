// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "glisson/ui/common/couplings.h"
#include "glisson/ui/guidance/correction_model.h"

namespace glisson::ui {

/// Begins and ends correcting by hand, and takes corrections back.
class CorrectionBox : public QWidget {
  Q_OBJECT
 public:
  /// @param model outlives the box.
  explicit CorrectionBox(CorrectionModel& model, QWidget* parent = nullptr);

 private:
  Couplings couplings_;
};

}  // namespace glisson::ui
