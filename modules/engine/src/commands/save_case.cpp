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
  if (!keeping.lock && keeping.writer && keeping.writer->is_there) throw held_error(told, *keeping.writer);
  keeping.writer.reset();
}

/// Others have saved where this was to go, since it began.
class Overtaken : public FileError {
 public:
  using FileError::FileError;
};

/// @throws Overtaken. Asked last: writing takes its time, and whoever takes a lock for stale removes it.
void require_not_overtaken(const Keeping& keeping) {
  const bool is_held = !keeping.lock || keeping.lock->holds();
  if (!is_held || edition_on_disk(keeping.folder) != keeping.edition)
    throw Overtaken(keeping.folder.string() + ": was replaced while it was written. Write it again.");
}

void go_beside(Keeping& keeping) {
  keeping.folder = unused_beside(keeping.folder);
  keeping.edition.clear();
  hold_or_tell(keeping.folder, keeping, nullptr);
}

/// Where the case goes, held, and the edition that it takes the place of: beside the wanted place where
/// others have saved there since. That is theirs, and both are kept.
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
  if (is_newer)
    go_beside(*keeping);
  else
    keeping->edition = edition_on_disk(keeping->folder);
  return keeping;
}

/// The path as the person gave it, unless the case goes beside it.
fs::path told_place(const fs::path& wanted, const Keeping& keeping) {
  return keeping.folder == case_place(wanted) ? wanted : keeping.folder;
}

/// Writes it there, or beside it where others come first. @return false: cancelled.
bool write_to(const fs::path& wanted, Keeping& keeping, const CaseState& state, const RunContext& context,
              std::vector<std::string>& notes) {
  const auto write = [&] {
    return engine::save_case(told_place(wanted, keeping), state, context, keeping.image, &notes,
                             [&keeping] { require_not_overtaken(keeping); });
  };
  try {
    return write();
  } catch (const Overtaken&) {
    go_beside(keeping);
    return write();
  }
}

/// Where the person wants it. @throws InputError nowhere has been said yet.
fs::path wanted_place(const fs::path& path, const CaseState& state) {
  if (path.empty() && state.path.empty())
    throw InputError("case", "path", "the case has never been saved",
                     "Choose a folder NAME.glisson to save it to");
  return path.empty() ? state.path : path;
}

/// The case as it stands there now.
Applied saved_at(const fs::path& wanted, const std::shared_ptr<Keeping>& keeping, const CaseState& state,
                 std::vector<std::string> notes) {
  Applied applied{state, {}, std::move(notes)};
  const fs::path place = told_place(wanted, *keeping);
  if (place != wanted) applied.notes.insert(applied.notes.begin(), "case.saved_beside " + place.string());
  keeping->edition = edition_on_disk(keeping->folder);
  applied.state.path = place;
  applied.state[part::keeping] = keeping;
  applied.is_final = true;
  applied.result = std::make_shared<const CaseOnDisk>(CaseOnDisk{editions(state)});
  return applied;
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
  const fs::path wanted = wanted_place(path, state);
  const auto keeping = place_of(wanted, state[part::keeping].get(), replaces);
  std::vector<std::string> notes;
  if (!write_to(wanted, *keeping, state, context, notes)) return {};
  return saved_at(wanted, keeping, state, std::move(notes));
}

}  // namespace glisson::engine
