// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/shell/case_opening.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/engine/case_io.h"
#include "glisson/engine/commands/import_cloud.h"
#include "glisson/engine/commands/import_image.h"
#include "glisson/engine/commands/import_labels.h"
#include "glisson/engine/commands/import_mesh.h"
#include "glisson/engine/commands/import_surfaces.h"
#include "glisson/engine/commands/open_case.h"
#include "glisson/engine/commands/set_calibration.h"
#include "glisson/engine/commands/set_video.h"
#include "glisson/engine/model_source.h"
#include "glisson/ui/common/built_in_atlas.h"

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

/// A mesh by what is in it. One that cannot be read goes by its name: who opens it says what is wrong.
engine::Command mesh_import(const fs::path& path, LengthUnit unit) {
  bool tetrahedra = ends_with_any(lower_name(path), {".vtu", ".msh"});
  try {
    tetrahedra = engine::model_source(path) == engine::ModelSource::tetrahedra;
  } catch (const Error&) {
  }
  if (tetrahedra) return engine::ImportMesh{path, unit};
  return engine::ImportSurfaces{path, unit, {}, built_in_atlas_if_any()};
}

Opening in_a_unit(const fs::path& path, const std::function<engine::Command(LengthUnit)>& command) {
  return {Opening::Way::in_a_unit, path, command(LengthUnit::millimetre), command};
}

bool holds_surfaces(const fs::path& folder) {
  std::error_code problem;
  for (const auto& entry : fs::directory_iterator(folder, problem))
    if (entry.is_regular_file(problem) && is_surface(lower_name(entry.path()))) return true;
  return false;
}

}  // namespace

std::optional<Opening> opening_of(const fs::path& given) {
  // "case.glisson/" and "case.glisson" are the same folder.
  const fs::path path = given.has_filename() ? given : given.parent_path();
  const std::string name = lower_name(path);
  using Way = Opening::Way;
  const auto plain = [&](engine::Command command) { return Opening{Way::plain, path, std::move(command)}; };
  const auto a_case = [](const fs::path& folder) {
    return Opening{Way::replace_case, folder, engine::OpenCase{folder}};
  };
  const Opening image{Way::import_image, path, engine::ImportImage{path}};
  std::error_code problem;
  if (engine::is_case(path)) return a_case(path);
  if (fs::is_directory(path, problem)) {
    if (holds_surfaces(path))
      return in_a_unit(path, [path](LengthUnit unit) {
        return engine::ImportSurfaces{path, unit, {}, built_in_atlas_if_any()};
      });
    return image;
  }
  if (name == "case.json") return a_case(path.parent_path());
  if (ends_with_any(name, {".seg.nrrd", ".dcm"}))
    return Opening{Way::import_labels, path, engine::ImportLabels{path, {}}};
  if (ends_with_any(name, {".nii", ".nii.gz", ".nrrd", ".nhdr", ".mha", ".mhd", ".vti", ".tar.gz", ".tgz",
                           ".tar", ".zip"}) ||
      name == "dicomdir")
    return image;
  if (is_surface(name) || ends_with_any(name, {".vtu", ".msh"}))
    return in_a_unit(path, [path](LengthUnit unit) { return mesh_import(path, unit); });
  if (ends_with_any(name, {".yml", ".yaml"})) return plain(engine::SetCalibration{path});
  if (ends_with_any(name, {".ply"}))
    return in_a_unit(path, [path](LengthUnit unit) { return engine::ImportCloud{path, unit}; });
  if (ends_with_any(name, {".mkv", ".mp4", ".avi", ".mov"}))
    return Opening{Way::open_video, path, engine::SetVideo{path, {}}};
  return std::nullopt;
}

}  // namespace glisson::ui
