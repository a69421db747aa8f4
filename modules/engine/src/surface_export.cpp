// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/surface_export.h"

#include <algorithm>
#include <set>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/core/output_file.h"
#include "glisson/engine/obstacle.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/model.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/model/label_surfaces.h"

namespace glisson::engine {
namespace {
namespace fs = std::filesystem;

bool is_one_of(const std::string& ending, const std::vector<std::string>& endings) {
  return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

constexpr const char* kLiver = "liver";

std::string name_of(const NamedSurface& surface) {
  return surface.structure == structure::kParenchyma ? kLiver : structure_name(surface.structure);
}

Cancellable<std::vector<NamedSurface>> surfaces_of(const CaseState& state, const RunContext& context,
                                                   std::vector<std::string>& notes) {
  const auto& labels = state[part::labels];
  const auto& model = state[part::model];
  require_parts(state, {either(part::labels, part::model)});
  const bool is_current = stage_state(state, part::model) == StageState::current;
  if (model && (is_current || !labels)) return model->model.surfaces;
  return model::surfaces_of_labels(*labels, context, notes);
}

/// What lies there from before and is not written anew would be taken for this patient's.
void require_own_folder(const fs::path& folder, const std::set<std::string>& files) {
  if (!fs::exists(folder)) return;
  if (!fs::is_directory(folder))
    throw InputError(folder.string(), "", "is no folder", "Name a folder; it is made if there is none");
  for (const auto& entry : fs::directory_iterator(folder))
    if (is_one_of(lower_extension(entry.path()), surface_endings()) &&
        !files.contains(entry.path().filename().string()))
      throw InputError(folder.string(), entry.path().filename().string(),
                       "lies there already and is none of the surfaces that are written",
                       "Choose an empty folder");
  for (const std::string& file : files) place_for_file(folder / file);  // refuses what can be no file
}

/// The folder itself, or what there is around it: on one file system with the files that are to be in it.
fs::path found_at(const fs::path& folder) {
  fs::path found = fs::absolute(folder).lexically_normal();
  while (!fs::exists(found) && found.has_relative_path()) found = found.parent_path();
  return found;
}

}  // namespace

const std::vector<std::string>& surface_endings() {
  static const std::vector<std::string> kEndings = {".stl", ".ply", ".obj", ".vtp"};
  return kEndings;
}

std::vector<fs::path> surfaces_in(const fs::path& folder, const std::string& ending) {
  std::vector<fs::path> found;
  std::error_code problem;
  for (const auto& entry : fs::directory_iterator(folder, problem)) {
    const std::string stem = entry.path().stem().string();
    if (entry.path().extension() == ending && (stem == kLiver || structure_named(stem)))
      found.push_back(entry.path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

Cancellable<std::vector<fs::path>> write_case_surfaces(const fs::path& folder, const std::string& ending,
                                                       const CaseState& state, const RunContext& context,
                                                       std::vector<std::string>& notes) {
  if (!is_one_of(ending, surface_endings()))
    throw InputError("surfaces", "format", "\"" + ending + "\" is none that surfaces are written in",
                     "Use stl, ply, obj or vtp");
  const auto surfaces = surfaces_of(state, context.part(0.0, 0.7), notes);
  if (!surfaces) return {};
  std::set<std::string> names;
  for (const NamedSurface& surface : *surfaces) names.insert(name_of(surface) + ending);
  require_own_folder(folder, names);
  const TemporaryFolder beside(found_at(folder));
  std::vector<fs::path> files;
  for (const NamedSurface& surface : *surfaces) {
    context.progress(0.7 + 0.3 * static_cast<double>(files.size()) / static_cast<double>(surfaces->size()),
                     "case.write");
    if (context.cancelled()) return {};
    files.push_back(folder / (name_of(surface) + ending));
    write_triangle_mesh(beside.path() / files.back().filename(), surface.mesh, LengthUnit::millimetre);
  }
  if (context.cancelled()) return {};
  fs::create_directories(folder);
  for (const fs::path& file : files) {
    const fs::path written = beside.path() / file.filename();
    if (fs::exists(file)) fs::permissions(written, fs::status(file).permissions());
    fs::rename(written, file);
  }
  flush_to_disk(folder);
  return files;
}

}  // namespace glisson::engine
