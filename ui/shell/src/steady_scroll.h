// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QScrollArea>

namespace glisson::ui {

/// Holds a panel, and stays where it is when a control that has the keyboard is switched off or hidden, as
/// Cancel is when the work has ended: Qt then gives the keyboard to the next one, and a QScrollArea scrolls
/// to that one, under the hand that lies over the panel. Tab scrolls as ever.
class SteadyScroll : public QScrollArea {
 public:
  using QScrollArea::QScrollArea;

 protected:
  bool focusNextPrevChild(bool next) override {
    const QWidget* from = focusWidget();
    const bool is_asked_for = from == nullptr || (from->isEnabled() && from->isVisibleTo(this));
    if (is_asked_for) return QScrollArea::focusNextPrevChild(next);
    // The parent's is what scrolls. NOLINTNEXTLINE(bugprone-parent-virtual-call)
    return QWidget::focusNextPrevChild(next);
  }
};

}  // namespace glisson::ui
