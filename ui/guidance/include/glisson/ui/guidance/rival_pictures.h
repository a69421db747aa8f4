// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <array>

#include "glisson/ui/common/couplings.h"
#include "glisson/ui/guidance/registration_model.h"

class QToolButton;

namespace glisson::ui {

/// The other places where the organ may be, side by side: the organ as it would lie there over the left
/// picture, or before the points where there is none, with its probability. A click takes the place.
class RivalPictures : public QWidget {
  Q_OBJECT
 public:
  /// Both outlive this.
  RivalPictures(EngineBridge& engine, RegistrationModel& model, QWidget* parent = nullptr);

 private:
  static constexpr std::size_t kMost = 3;
  void show_case();

  EngineBridge& engine_;
  std::array<QToolButton*, kMost> buttons_{};
  std::shared_ptr<const Registration> shown_;
  std::shared_ptr<const void> frame_;
  Couplings couplings_;
};

}  // namespace glisson::ui
