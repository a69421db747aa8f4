// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace glisson::ui {

/// The wheel scrolls a panel. A setting that comes under the pointer on the way does not turn with it, unless
/// a person has chosen it before.
class WheelGuard : public QObject {
  Q_OBJECT
 public:
  /// Over all panels of the program, as long as it lives.
  explicit WheelGuard(QObject* parent);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace glisson::ui
