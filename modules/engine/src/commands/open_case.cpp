// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/open_case.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "glisson/engine/case_io.h"
#include "glisson/engine/parts/keeping.h"

namespace glisson::engine {

namespace {

constexpr int kTrials = 3;

/// Reads the case and its edition again where somebody has saved it meanwhile.
Cancellable<CaseState> read_steadily(const std::filesystem::path& path, Keeping& keeping,
                                     const RunContext& context, std::vector<std::string>& notes) {
  for (int trial = 1;; ++trial) {
    std::vector<std::string> lost;
    keeping.edition = edition_on_disk(keeping.folder);
    auto opened = engine::open_case(path, context, &lost);
    if (opened) keeping.image.remember(*opened, keeping.folder, keeping.folder);
    if (opened && edition_on_disk(keeping.folder) != keeping.edition) {
      keeping.image = {};  // its file may be that of the other edition
      if (trial < kTrials) continue;
    }
    notes.insert(notes.end(), lost.begin(), lost.end());
    return opened;
  }
}

/// The place, held where it is opened for writing. @throws InputError who else has it.
std::shared_ptr<Keeping> held_for(const OpenCase& command, const Keeping* kept) {
  auto keeping = std::make_shared<Keeping>();
  keeping->folder = case_place(command.path);
  if (command.access == OpenCase::Access::read) return keeping;
  if (std::filesystem::exists(keeping->folder)) hold(*keeping, kept);
  if (keeping->writer && command.access == OpenCase::Access::write)
    throw held_error(command.path, *keeping->writer);
  return keeping;
}

/// Why it is open for reading, if it is.
std::vector<std::string> notes_of(const Keeping& keeping) {
  if (!keeping.writer) return {};
  return {keeping.writer->is_there ? "case.open_for_reading " + keeping.writer->told()
                                   : "case.folder_not_writable"};
}

}  // namespace

CommandTraits OpenCase::traits() const {
  return {.code = "open_case", .writes = Parts::all(), .notice = Notice::files};
}

Cancellable<Applied> OpenCase::apply(const CaseState& before, const RunContext& context) const {
  const auto keeping = held_for(*this, before[part::keeping].get());
  std::vector<std::string> notes = notes_of(*keeping);
  auto opened = read_steadily(path, *keeping, context, notes);
  if (!opened) return {};
  (*opened)[part::keeping] = keeping;
  const auto on_disk = std::make_shared<const CaseOnDisk>(CaseOnDisk{editions(*opened)});
  return Applied{
      .state = std::move(*opened), .notes = std::move(notes), .result = on_disk, .keeps_stamps = true};
}

}  // namespace glisson::engine
