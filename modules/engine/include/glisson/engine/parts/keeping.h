// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "glisson/core/error.h"
#include "glisson/engine/case_lock.h"
#include "glisson/engine/case_state.h"
#include "glisson/engine/saved_image.h"

namespace glisson::engine {

/// How the case that is open stands on the disk: where, in which edition, and who may write it.
struct Keeping {
  std::filesystem::path folder;
  std::string edition;                   ///< that was read or written last; see edition_on_disk
  std::shared_ptr<const CaseLock> lock;  ///< null: it is open for reading
  std::optional<CaseOwner> writer;       ///< who else has it, when it is open for reading
  SavedImage image;                      ///< which file holds the image
};

namespace part {
/// Not of the patient: it goes with the state, so that the case is held as long as anybody works on it.
extern const PartOf<Keeping> keeping;
}  // namespace part

/// Holds `keeping.folder` for writing: with the lock that this program has on it already, else with a new
/// one; where another one has it, `keeping.writer` says who. @param now of the case that is open; may be
/// null.
void hold(Keeping& keeping, const Keeping* now);
/// For a person who wants to write what another has open.
InputError held_error(const std::filesystem::path& path, const CaseOwner& owner);

}  // namespace glisson::engine
