// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSettings>
#include <memory>

namespace glisson::ui {

/// What this user has chosen, on this computer, whatever the case (glisson.ini; in the folder that
/// GLISSON_SETTINGS names, if it is set).
std::unique_ptr<QSettings> user_settings();

}  // namespace glisson::ui
