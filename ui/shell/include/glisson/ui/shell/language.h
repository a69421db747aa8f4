// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QCoreApplication;

namespace glisson::ui {

/// Speaks the person's language from now on, where there is a translation, and keeps numbers in files as they
/// are everywhere: Qt takes over the system's locale, in which C's functions may write and expect "0,5".
/// Call once, right after the application object was made.
void set_up_language(QCoreApplication& application);

}  // namespace glisson::ui
