// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>

class QWidget;

namespace glisson::ui {

/// Asks why the liver of a file lies left of the vena cava: after a right hepatectomy it does, in a mirrored
/// image, too, and no shape tells the two apart. Does not stop the window.
/// @param then is called where the person says that the liver was operated on (LeftLiver::asked). Else
/// nothing is imported: that is the answer of Enter and Escape.
void ask_left_liver(QWidget* parent, const std::filesystem::path& path, const std::function<void()>& then);

}  // namespace glisson::ui
