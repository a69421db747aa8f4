// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/parts/keeping.h"

namespace glisson::engine {

const PartOf<Keeping> part::keeping{{.code = "keeping", .stands_alone = true, .is_input = false}};

void hold(Keeping& keeping, const Keeping* now) {
  if (now != nullptr && now->lock && now->folder == keeping.folder && now->lock->holds())
    keeping.lock = now->lock;
  else
    keeping.lock = CaseLock::take(keeping.folder, keeping.writer);
}

InputError held_error(const std::filesystem::path& path, const CaseOwner& owner) {
  const std::string file = lock_file_of(case_place(path)).string();
  if (!owner.is_there)
    return {path.string(), "", "cannot be opened for writing: " + file + " cannot be written",
            "Check the permissions of its folder, or open it for reading"};
  return {path.string(), "", "is open for writing by " + owner.told(),
          "Close it there, or save under another name. If that program runs no longer, remove " + file};
}

}  // namespace glisson::engine
