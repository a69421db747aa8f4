// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>

#include "glisson/core/units.h"

class QWidget;

namespace glisson::ui {

/// Asks in which unit the lengths of a mesh, of surfaces or of a cloud are: their files do not say. Does not
/// stop the window.
/// @param path the file, or the folder of several.
/// @param then is called with the answer; not at all where the person cancels.
void ask_unit(QWidget* parent, const std::filesystem::path& path,
              const std::function<void(LengthUnit)>& then);

}  // namespace glisson::ui
