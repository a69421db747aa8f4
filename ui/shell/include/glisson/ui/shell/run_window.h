// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

class QApplication;

namespace glisson::ui {

/// What must be set before the QApplication is made (OpenGL's surface format).
void prepare_application();
/// Name, icon, dark style and the language of the user.
void dress_application(QApplication& application);
/// The whole window: makes the QApplication, opens `path` unless it is empty, runs until it is closed.
/// @return the process's exit code.
int run_window(int argc, char** argv, const std::filesystem::path& path);

}  // namespace glisson::ui
