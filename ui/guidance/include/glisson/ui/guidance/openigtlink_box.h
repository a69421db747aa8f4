// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "glisson/ui/common/couplings.h"
#include "glisson/ui/guidance/openigtlink_model.h"

namespace glisson::ui {

/// The switch for telling other programs, where it listens, and how many have connected.
class OpenIgtLinkBox : public QWidget {
  Q_OBJECT
 public:
  /// @param model outlives the box.
  explicit OpenIgtLinkBox(OpenIgtLinkModel& model, QWidget* parent = nullptr);

 private:
  Couplings couplings_;
};

}  // namespace glisson::ui
