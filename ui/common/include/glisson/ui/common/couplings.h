// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QProperty>
#include <list>

namespace glisson::ui {

/// Keeps widgets as properties say: what is coupled is shown at once, and again whenever the property
/// changes, as long as both the property and these couplings live. GUI thread.
class Couplings {
 public:
  /// @param show is called with the property's value.
  template <class T, class Show>
  void add(QProperty<T>& property, Show show) {
    show(property.value());
    notifiers_.push_back(property.addNotifier([&property, show] { show(property.value()); }));
  }

 private:
  std::list<QPropertyNotifier> notifiers_;
};

}  // namespace glisson::ui
