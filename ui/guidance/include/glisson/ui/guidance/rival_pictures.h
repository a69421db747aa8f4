// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <array>
#include <optional>

#include "glisson/ui/common/couplings.h"
#include "glisson/ui/guidance/registration_model.h"

class QToolButton;

namespace glisson::ui {

/// The other places where the organ may be, side by side: the organ as it would lie there over the left
/// picture, or before the points where there is none, with its probability. A click takes the place; a second
/// one soon after it is none, for by then the pictures have changed places.
class RivalPictures : public QWidget {
  Q_OBJECT
 public:
  /// Both outlive this.
  RivalPictures(EngineBridge& engine, RegistrationModel& model, QWidget* parent = nullptr);

 private:
  static constexpr std::size_t kMost = 3;
  void show_case();
  void take(std::size_t rival);
  void finish(const engine::Outcome& outcome);
  /// Why no place can be taken now; empty: one can.
  QString obstacle() const;

  EngineBridge& engine_;
  RegistrationModel& model_;
  std::array<QToolButton*, kMost> buttons_{};
  std::shared_ptr<const Registration> shown_;
  std::shared_ptr<const void> frame_;
  std::optional<engine::CommandId> taking_;  ///< until a double click would be over, too
  Couplings couplings_;
};

}  // namespace glisson::ui
