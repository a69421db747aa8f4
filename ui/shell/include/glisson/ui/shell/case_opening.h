// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "glisson/core/units.h"
#include "glisson/engine/command.h"

namespace glisson::ui {

/// What opening or dropping a path means.
struct Opening {
  /// Whether the window has a question of its own before it does it.
  enum class Way {
    plain,          ///< the command is posted
    replace_case,   ///< what is not saved would be lost
    import_image,   ///< which series, and whose it is
    import_labels,  ///< what they mean, where the file does not say
    in_a_unit,      ///< of which length; no mesh and no cloud says it
    open_video      ///< its first frame follows
  };
  Way way = Way::plain;
  std::filesystem::path path;  ///< that the command is for: a case's folder, not its case.json
  engine::Command command;
  std::function<engine::Command(LengthUnit)> in = {};  ///< the command, of Way::in_a_unit
};

/// A case, a folder of DICOM slices, a folder of surfaces, a volume, labels, a surface, a calibration, a
/// cloud or a video. By name and kind only; nothing is read but folders' entries. Empty: nothing that Glisson
/// opens.
std::optional<Opening> opening_of(const std::filesystem::path& path);

}  // namespace glisson::ui
