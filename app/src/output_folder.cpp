// SPDX-License-Identifier: GPL-3.0-or-later
#include "output_folder.h"

#include <sys/stat.h>

#include <QString>
#include <optional>
#include <system_error>
#include <vector>

#include "cli.h"
#include "glisson/core/error.h"
#include "glisson/core/output_file.h"
#include "glisson/engine/case_io.h"
#include "glisson/engine/case_lock.h"
#include "glisson/engine/parts/keeping.h"
#include "glisson/ui/common/texts.h"

namespace glisson::app {
namespace fs = std::filesystem;
namespace {

/// Where an entry of an own folder goes: through links of this user, never in the place of a device.
fs::path place_in(const fs::path& folder, const fs::directory_entry& entry) {
  const fs::path target = folder / entry.path().filename();
  if (!entry.is_directory()) return place_for_file(target);
  const fs::path place = end_of_links(target);
  if (fs::exists(place) && !fs::is_directory(place))
    throw FileError(target.string() + ": is a file, a folder is needed here. Choose another name.");
  return place;
}

/// What lies on another disk cannot be replaced in one step.
void require_same_disk(const fs::path& from, const fs::path& target, const fs::path& place) {
  struct stat here = {}, there = {};
  if (::stat(from.c_str(), &here) != 0 || ::stat(place.parent_path().c_str(), &there) != 0 ||
      here.st_dev == there.st_dev)
    return;
  throw FileError(target.string() +
                  ": leads to another disk. Remove the link, or name a folder on that disk.");
}

/// Cases that are to be replaced, held meanwhile.
using Held = std::vector<std::shared_ptr<const engine::CaseLock>>;

/// Finds out before anything is moved. @throws InputError somebody has a case open.
void check_places(const fs::path& from, const fs::path& to, Held& held) {
  for (const auto& entry : fs::directory_iterator(from)) {
    const fs::path target = to / entry.path().filename();
    const fs::path place = place_in(to, entry);
    require_same_disk(entry.path(), target, place);
    if (engine::holds_case(entry.path()) && engine::holds_case(place)) {
      std::optional<engine::CaseOwner> owner;
      held.push_back(engine::CaseLock::take(engine::case_place(place), owner));
      if (!held.back()) throw engine::held_error(target, owner.value_or(engine::CaseOwner{}));
    } else if (entry.is_directory() && fs::is_directory(place)) {
      check_places(entry.path(), place, held);
    }
  }
}

/// Moves what a folder holds to another one, folder by folder: what is there besides stays.
void merge(const fs::path& from, const fs::path& to) {
  for (const auto& entry : fs::directory_iterator(from)) {
    const fs::path place = place_in(to, entry);
    if (engine::holds_case(entry.path()) && engine::holds_case(place)) {
      for (const std::string& note : engine::put_case(entry.path(), engine::case_place(place)))
        say(Cli::tr("note: ") + ui::note_text(note));
    } else if (entry.is_directory() && fs::is_directory(place)) {
      merge(entry.path(), place);
    } else {
      fs::rename(entry.path(), place);
    }
  }
}

}  // namespace

OutputFolder::OutputFolder(const fs::path& wanted)
    : told_(wanted), wanted_(end_of_links(fs::absolute(wanted).lexically_normal())) {
  if (!wanted_.has_filename()) wanted_ = end_of_links(wanted_.parent_path());
  std::error_code failure;
  if (fs::exists(wanted_, failure) && !fs::is_directory(wanted_, failure))
    throw FileError(told_.string() + ": is a file, a folder is needed here. Choose another name.");
  if (!fs::is_directory(wanted_.parent_path(), failure))
    throw FileError(told_.string() + ": its folder does not exist. Create it or choose another.");
  sweep_leftovers(wanted_.parent_path());
  working_ = std::make_unique<TemporaryFolder>(wanted_.parent_path());
  fs::create_directory(path(), failure);
  if (failure)
    throw FileError(told_.string() + ": could not be written (" + failure.message() +
                    "). Check permissions and free space.");
}

fs::path OutputFolder::path() const { return working_->path() / wanted_.filename(); }

void OutputFolder::commit(bool whole) {
  constexpr const char* kIncomplete = "INCOMPLETE";
  if (!whole)
    write_file_atomically(path() / kIncomplete,
                          Cli::tr("This was cut short: what is here is not all.").toStdString() + "\n");
  try {
    Held held;
    if (fs::exists(wanted_)) check_places(path(), wanted_, held);
    if (whole) fs::remove(wanted_ / kIncomplete);
    if (!fs::exists(wanted_))
      fs::rename(path(), wanted_);
    else
      merge(path(), wanted_);
  } catch (const fs::filesystem_error& failure) {
    throw FileError(told_.string() + ": could not be completed (" + failure.code().message() +
                    "). Check permissions and free space.");
  }
}

}  // namespace glisson::app
