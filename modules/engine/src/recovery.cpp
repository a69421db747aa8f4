// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/recovery.h"

#include <fcntl.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>
#include <system_error>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/core/json_file.h"
#include "glisson/core/log_file.h"
#include "glisson/engine/case_io.h"
#include "recovery_copy.h"

namespace glisson::engine {
namespace fs = std::filesystem;
using nlohmann::json;
namespace {

/// Empty: there is no whole copy. @throws FileError, filesystem_error: nobody can tell now.
Recoverable copy_in(const fs::path& folder) {
  Recoverable found{folder, folder / kCopyName, {}, {}, {}};
  if (!fs::exists(folder / kSaidName) || !fs::exists(found.copy) || !holds_case(found.copy)) return {};
  try {
    const json said = read_json(folder / kSaidName);
    found.of = said.at("of").get<std::string>();
    found.edition = said.at("edition");
    found.saved = said.at("saved");
    return found;
  } catch (const InputError&) {
    return {};
  } catch (const json::exception&) {
    return {};
  }
}

/// The folder, held; nothing where another program has it.
Claim hold(const fs::path& folder) {
  Claim claim(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
  if (claim.descriptor() < 0 || !claim.take() || !claim.is_at(folder)) return {};
  return claim;
}

}  // namespace

fs::path recovery_root() {
  const fs::path state = state_folder();
  return state.empty() ? state : state / "recovery";
}

RecoveryFolder::RecoveryFolder(const fs::path& root) {
  std::error_code failure;
  fs::create_directories(root, failure);
  if (!failure) fs::permissions(root, fs::perms::owner_all, failure);
  path_ = failure ? fs::path() : Claim::make_folder(root, claim_);
  if (path_.empty())
    throw FileError(root.string() + ": no folder for recovery can be made here (" +
                    (failure ? failure.message() : std::string(std::strerror(errno))) +
                    "). Check permissions and space.");
}

RecoveryFolder::~RecoveryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

void RecoveryFolder::clear() const {
  std::error_code ignored;
  fs::remove(path_ / kSaidName, ignored);  // first: without it a copy is none
  fs::remove_all(path_ / kCopyName, ignored);
}

std::vector<Recoverable> find_recoverable(const fs::path& root) {
  std::vector<Recoverable> all;
  std::error_code failure;
  std::vector<fs::path> folders;
  for (auto entry = fs::directory_iterator(root, failure); !failure && entry != fs::directory_iterator();
       entry.increment(failure))
    if (entry->path().filename().string().starts_with(".glisson-")) folders.push_back(entry->path());
  for (const fs::path& folder : folders) {
    const Claim claim = hold(folder);
    if (claim.descriptor() < 0) continue;
    try {
      Recoverable found = copy_in(folder);
      if (found.folder.empty())
        fs::remove_all(folder, failure);
      else
        all.push_back(std::move(found));
    } catch (const std::exception&) {
      continue;  // it may be the only copy of somebody's work: another start may be able to read it
    }
  }
  std::sort(all.begin(), all.end(),
            [](const Recoverable& a, const Recoverable& b) { return a.saved > b.saved; });
  return all;
}

void discard(const Recoverable& copy) {
  const Claim claim = hold(copy.folder);
  std::error_code ignored;
  if (claim.descriptor() >= 0) fs::remove_all(copy.folder, ignored);
}

}  // namespace glisson::engine
