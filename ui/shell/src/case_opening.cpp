// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/shell/case_opening.h"
#include "glisson/core/files.h"

#include <algorithm>
#include <array>
#include <string>

namespace glisson::ui {
namespace {

namespace fs = std::filesystem;

bool ends_with_any(const std::string& name, std::initializer_list<const char*> endings) {
  return std::any_of(endings.begin(), endings.end(),
                     [&](const char* ending) { return name.ends_with(ending); });
}

bool is_surface(const std::string& name) { return ends_with_any(name, {".vtk", ".vtp", ".stl", ".obj"}); }

bool holds_surfaces(const fs::path& folder) {
  std::error_code problem;
  for (const auto& entry : fs::directory_iterator(folder, problem))
    if (entry.is_regular_file(problem) && is_surface(lower_name(entry.path()))) return true;
  return false;
}

}  // namespace

std::optional<engine::Command> command_to_open(const fs::path& given) {
  // "case.glisson/" and "case.glisson" are the same folder.
  const fs::path path = given.has_filename() ? given : given.parent_path();
  const std::string name = lower_name(path);
  std::error_code problem;
  if (fs::is_directory(path, problem)) {
    if (name.ends_with(".glisson")) return engine::OpenCase{path};
    if (holds_surfaces(path)) return engine::ImportSurfaces{path, LengthUnit::millimetre, {}};
    return engine::ImportImage{path};
  }
  if (name == "case.json") return engine::OpenCase{path.parent_path()};
  if (ends_with_any(name, {".seg.nrrd"})) return engine::ImportLabels{path, {}};
  if (ends_with_any(name, {".nii", ".nii.gz", ".nrrd", ".nhdr", ".mha", ".mhd", ".vti", ".tar.gz", ".tgz"}))
    return engine::ImportImage{path};
  if (is_surface(name)) return engine::ImportSurfaces{path, LengthUnit::millimetre, {}};
  if (ends_with_any(name, {".vtu", ".msh"})) return engine::ImportMesh{path, LengthUnit::millimetre};
  if (ends_with_any(name, {".yml", ".yaml"})) return engine::SetCalibration{path};
  if (ends_with_any(name, {".ply"})) return engine::ImportCloud{path, LengthUnit::millimetre};
  if (ends_with_any(name, {".mkv", ".mp4", ".avi", ".mov"})) return engine::SetVideo{path, {}};
  return std::nullopt;
}

}  // namespace glisson::ui
