// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <functional>
#include <set>

#include "glisson/volume/label_volume.h"

class QWidget;

namespace glisson::ui {

/// Asks before labels that a hand has corrected are replaced by others where no preview can show the
/// difference. Does not stop the window.
/// @param edited see engine::edited_by_hand(). @param told what takes their place.
/// @param then is called where the person says so. Else nothing happens: that is the answer of Enter and
/// Escape.
void ask_over_hand_work(QWidget* parent, const std::set<Label>& edited, const QString& told,
                        const std::function<void()>& then);

}  // namespace glisson::ui
