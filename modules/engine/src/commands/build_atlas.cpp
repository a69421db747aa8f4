// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/build_atlas.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "atlas_member.h"
#include "glisson/core/error.h"
#include "glisson/core/folder_exchange.h"
#include "glisson/core/note_value.h"
#include "glisson/engine/case_io.h"
#include "glisson/engine/review.h"

namespace glisson::engine {
namespace fs = std::filesystem;
namespace {

/// A case, or the cases in a folder, by name.
std::vector<fs::path> cases_in(const fs::path& path) {
  if (is_case(path)) return {path};
  if (!fs::is_directory(path)) throw FileError(path.string() + ": does not exist. Check the path.");
  std::vector<fs::path> found;
  for (const fs::directory_entry& entry : fs::directory_iterator(path))
    if (entry.is_directory() && holds_case(entry.path())) found.push_back(entry.path());
  if (found.empty())
    throw InputError(path.string(), "cases", "are none in this folder", "Name a case or a folder of cases");
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<fs::path> all_cases(const std::vector<fs::path>& paths) {
  std::vector<fs::path> all;
  for (const fs::path& path : paths) {
    const std::vector<fs::path> found = cases_in(path);
    all.insert(all.end(), found.begin(), found.end());
  }
  return all;
}

/// "a" of "cases/a.glisson/".
std::string name_of(const fs::path& path) {
  const fs::path place = fs::absolute(path).lexically_normal();
  return (place.has_filename() ? place : place.parent_path()).stem().string();
}

/// Of what the atlas reads of a case.
bool is_approved(const CaseState& state) {
  constexpr std::array kRead = {structure::kParenchyma, structure::kVenaCava, structure::kGallbladder,
                                structure::kPortalVein};
  for (const auto& [review, labels] : unapproved_labels(state))
    for (const Label label : labels)
      if (std::find(kRead.begin(), kRead.end(), label) != kRead.end()) return false;
  return true;
}

/// Those that are given, and those of the cases; which of these were left out is noted.
Cancellable<std::vector<atlas::Member>> livers_of(const BuildAtlas& command, const RunContext& context,
                                                  std::vector<std::string>& notes) {
  std::vector<atlas::Member> livers = command.members;
  const std::vector<fs::path> all = all_cases(command.cases);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string name = name_of(all[i]);
    std::vector<std::string> lost;  // cloud and operations, of which the atlas reads nothing
    const auto opened = open_case(all[i], context.quiet(), &lost);
    if (!opened) return {};
    if (command.unapproved || is_approved(*opened))
      livers.push_back(atlas_member(name, *opened));
    else
      notes.push_back("atlas.not_approved " + note_value(name));
    context.progress(0.2 * static_cast<double>(i + 1) / static_cast<double>(all.size()), "atlas.livers");
  }
  return livers;
}

/// Before the work, so that minutes of it are not lost.
void check_folder(const fs::path& out) {
  if (out.empty()) return;
  fs::path around = place_for_folder(out).parent_path();
  while (!fs::exists(around)) around = around.parent_path();
  if (!fs::is_directory(around) || ::access(around.c_str(), W_OK) != 0)
    throw FileError(out.string() + ": its folder cannot be written to. Choose another folder.");
  if (!fs::exists(out)) return;
  if (!fs::is_directory(out) || (!fs::is_empty(out) && !fs::exists(out / "atlas.json")))
    throw InputError(out.string(), "folder", "holds something else than an atlas", "Name a new folder");
}

/// @param[out] notes also of the livers that were left out.
Cancellable<atlas::BuildResult> built_of(const BuildAtlas& command, const RunContext& context,
                                         std::vector<std::string>& notes) {
  require(command.base != nullptr, "an atlas is built on a base");
  auto livers = livers_of(command, context, notes);
  if (!livers) return {};
  auto built = atlas::build(std::move(*livers), *command.base, command.options, context.part(0.2, 1.0));
  if (built && built->atlas.structures.empty() && !command.out.empty())
    throw InputError("atlas", "structures", "are none",
                     "Place notch, margin or vena cava in five cases at least, or build on another atlas");
  if (built) notes.insert(notes.end(), built->notes.begin(), built->notes.end());
  return built;
}

}  // namespace

CommandTraits BuildAtlas::traits() const { return {.code = "build_atlas"}; }

Cancellable<Applied> BuildAtlas::apply(const CaseState& state, const RunContext& context) const {
  check_folder(out);
  Applied applied{state};
  auto built = built_of(*this, context, applied.notes);
  if (!built) return {};
  if (!out.empty()) atlas::replace_atlas(out, built->atlas);
  applied.figures = atlas::figures_of(*built);
  applied.result = std::make_shared<const Result>(std::move(*built));
  return applied;
}

}  // namespace glisson::engine
