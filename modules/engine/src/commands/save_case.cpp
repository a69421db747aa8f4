// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/save_case.h"

#include <memory>
#include <optional>

#include "glisson/core/error.h"
#include "glisson/engine/case_io.h"
#include "glisson/engine/parts/keeping.h"

namespace glisson::engine {

namespace {
namespace fs = std::filesystem;

/// "liver (2).glisson" beside "liver.glisson".
fs::path unused_beside(const fs::path& folder) {
  for (int number = 2;; ++number) {
    const fs::path name = folder.parent_path() / (folder.stem().string() + " (" + std::to_string(number) +
                                                  ")" + folder.extension().string());
    if (!fs::exists(fs::symlink_status(name))) return name;
  }
}

/// @throws InputError who else has it.
void hold_or_tell(const fs::path& told, Keeping& keeping, const Keeping* before) {
  hold(keeping, before);
  // Where no lock can be written, no case can either: saving says it better.
  if (!keeping.lock && keeping.writer && !keeping.writer->host.empty())
    throw held_error(told, *keeping.writer);
  keeping.writer.reset();
}

/// Where the case goes, held: beside the wanted place where others have saved there since. That is theirs,
/// and both are kept.
std::shared_ptr<Keeping> place_of(const fs::path& wanted, const Keeping* before, bool replaces) {
  auto keeping = std::make_shared<Keeping>();
  if (before != nullptr) keeping->image = before->image;
  keeping->folder = case_place(wanted);
  const bool is_own = before != nullptr && before->folder == keeping->folder;
  hold_or_tell(wanted, *keeping, before);
  if (!is_own && !replaces && holds_case(keeping->folder))
    throw InputError(wanted.string(), "", "is another case",
                     "Choose another name, or say that it is replaced");
  const bool is_newer =
      is_own && fs::exists(keeping->folder) && edition_on_disk(keeping->folder) != before->edition;
  if (!is_newer) return keeping;
  keeping->folder = unused_beside(keeping->folder);
  hold_or_tell(keeping->folder, *keeping, nullptr);
  return keeping;
}

/// Where the person wants it. @throws InputError nowhere has been said yet.
fs::path wanted_place(const fs::path& path, const CaseState& state) {
  if (path.empty() && state.path.empty())
    throw InputError("case", "path", "the case has never been saved",
                     "Choose a folder NAME.glisson to save it to");
  return path.empty() ? state.path : path;
}

}  // namespace

CommandTraits SaveCase::traits() const {
  CommandTraits traits{.code = "save_case", .writes = {part::keeping}, .notice = Notice::files};
  // The live view goes on beside it and is not saved.
  for (const Part part : all_parts())
    if (part.type().is_saved()) traits.reads.add(part);
  return traits;
}

Cancellable<Applied> SaveCase::apply(const CaseState& state, const RunContext& context) const {
  Applied applied{state};
  const fs::path wanted = wanted_place(path, state);
  const auto keeping = place_of(wanted, state[part::keeping].get(), replaces);
  const bool is_beside = keeping->folder != case_place(wanted);
  const fs::path& place = is_beside ? keeping->folder : wanted;
  if (is_beside) applied.notes.push_back("case.saved_beside " + place.string());
  if (!engine::save_case(place, state, context, keeping->image, &applied.notes)) return {};
  keeping->edition = edition_on_disk(keeping->folder);
  applied.state.path = place;
  applied.state[part::keeping] = keeping;
  applied.is_final = true;
  applied.result = std::make_shared<const CaseOnDisk>(CaseOnDisk{editions(state)});
  return applied;
}

}  // namespace glisson::engine
