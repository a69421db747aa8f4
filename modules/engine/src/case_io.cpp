// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/case_io.h"

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <system_error>

#include "case_manifest.h"
#include "case_reach.h"
#include "glisson/core/claim.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/core/folder_exchange.h"
#include "glisson/core/json_file.h"
#include "glisson/engine/case_lock.h"
#include "glisson/engine/saved_image.h"
#include "ranged.h"

namespace glisson::engine {
namespace fs = std::filesystem;
using nlohmann::json;
namespace {

constexpr const char* kFormat = "glisson-case";

/// Whether a part goes to the disk as it stands in this state.
bool is_kept(const CaseState& state, Part part) {
  const PartSpec& spec = part.type().spec();
  return part.type().is_saved() && state.has(part) && (!spec.is_savable || spec.is_savable(state));
}

/// Of what a part was made. What it outlives and is never kept, as a video that another computer sends, would
/// be missed when the case is opened: the part is no longer made from it, as it is not from what was left out
/// then (free_of_left_out).
json made_from_of(const CaseState& state, Part part) {
  const std::vector<Part>& outlived = part.type().spec().outlives;
  json made_from = json::object();
  for (const auto& [input, revision] : state.stamp(part).made_from) {
    const bool stays_behind = std::ranges::find(outlived, input) != outlived.end() && state.has(input) &&
                              !is_kept(state, input) && state.stamp(input).revision == revision;
    if (!stays_behind) made_from[std::string(input.code())] = revision;
  }
  return made_from;
}

/// What a person may say at any time, and had not when this part was made by an edition that did not know it.
void add_unsaid(Stamp& stamp, Part part) {
  for (const Part input : part.type().spec().made_of)
    if (input.type().spec().stands_alone && input.type().spec().is_input && !stamp.made_from.empty())
      stamp.made_from.try_emplace(input, 0);
}

Stamp read_stamp(const fs::path& folder, const json& entry, Part of) {
  Stamp stamp;
  stamp.revision = ranged<std::uint64_t>(folder, entry, "revision", 0.0, kMostRevisions);
  if (of.type().spec().stands_alone) return stamp;  // earlier programs wrote from what
  for (const Part part : all_parts()) {
    const json& inputs = entry.at("made_from");
    const std::string code(part.code());
    if (inputs.contains(code))
      stamp.made_from[part] = ranged<std::uint64_t>(folder, inputs, code.c_str(), 0.0, kMostRevisions);
  }
  add_unsaid(stamp, of);
  return stamp;
}

/// Frees a part of inputs that the case names as it was made from them, and was opened without
/// (PartSpec::outlives).
void free_of_left_out(const fs::path& folder, const json& parts, Part of, CaseState& state) {
  auto& made_from = state.stamp(of).made_from;
  for (const Part input : of.type().spec().outlives) {
    const auto entry = parts.find(input.code());
    const auto then = made_from.find(input);
    if (state.has(input) || entry == parts.end() || then == made_from.end()) continue;
    if (read_stamp(folder, *entry, input).revision == then->second) made_from.erase(then);
  }
}

/// Writes the files of every part that there is. @return case.json, or nothing when cancelled.
/// @param taken_over their files are there already.
std::optional<json> write_parts(const CaseFolder& folder, const CaseState& state, const Parts& taken_over) {
  json parts = json::object();
  double done = 0.0;
  for (const Part part : all_parts()) {
    folder.context.progress(0.8 * done++ / static_cast<double>(all_parts().size()), "case.write");
    if (folder.context.cancelled()) return {};
    if (!is_kept(state, part)) continue;
    const PartSpec& spec = part.type().spec();
    json entry = taken_over.has(part) ? spec.entry(state) : spec.save(state, folder);
    entry["revision"] = state.stamp(part).revision;
    entry["made_from"] = made_from_of(state, part);
    parts[std::string(part.code())] = entry;
  }
  if (folder.context.cancelled()) return {};
  return json{{"format", kFormat}, {"version", kCaseFormatVersion}, {"parts", parts}};
}

/// Parts of a case whose files need not be read.
struct Known {
  const CaseState* state = nullptr;  ///< has them; null: there are none
  Parts parts = {};
};

/// Of the time in which a case is read.
double reading_share(Part part) {
  double said = 0.0;
  for (const Part one : all_parts()) said += one.type().spec().reading_share;
  const double share = part.type().spec().reading_share;
  return share > 0.0 ? share : (1.0 - said) / static_cast<double>(all_parts().size());
}

/// As open_case. @param home where the case stands in the end; empty: where it is read.
Cancellable<CaseState> read_case(const fs::path& given, const fs::path& home, const RunContext& context,
                                 std::vector<std::string>* lost, const Known& known);

/// Compares what was written with what was to be; cannot be cancelled. @param taken_over parts whose files
/// are those of an earlier case: they were read back then, and their sums are still those. @throws FileError.
void verify(const fs::path& folder, const fs::path& home, const CaseState& state, const Parts& taken_over,
            const RunContext& context) {
  const auto checked = [&context](double share, std::string_view) { context.progress(share, "case.verify"); };
  checked(0.0, {});
  const RunContext reading(checked, nullptr, context.seed());
  const auto read = read_case(folder, home, reading.part(0.0, 0.8), nullptr, {&state, taken_over});
  checked(0.8, {});
  const bool same = read && std::all_of(all_parts().begin(), all_parts().end(), [&](Part part) {
                      const PartSpec& spec = part.type().spec();
                      const bool kept = is_kept(state, part);
                      return read->has(part) == kept && (!kept || spec.same(state, *read));
                    });
  if (!same)
    throw FileError(folder.string() +
                    ": the case reads back differently from what was written. Check the disk's free space; "
                    "the old case stands.");
}

/// What is not the case's may be a pipe that nobody reads.
void flush_tree(const fs::path& folder) {
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const fs::file_status status = entry.symlink_status();
    if (fs::is_regular_file(status) || fs::is_directory(status)) flush_to_disk(entry.path());
  }
  flush_to_disk(folder);
}

}  // namespace

bool holds_case(const fs::path& folder) {
  std::error_code ignored;
  return fs::exists(folder / kCaseFile, ignored);
}

bool is_case(const fs::path& path) {
  std::error_code ignored;
  const fs::path name = path.has_filename() ? path.filename() : path.parent_path().filename();
  return fs::is_directory(path, ignored) && (holds_case(path) || name.extension() == ".glisson");
}

std::string edition_on_disk(const fs::path& folder) {
  // It is asked before the case is opened, which refuses what is not its own.
  if (!holds_case(folder) || !lies_in_case(folder, folder / kCaseFile)) return {};
  // FNV-1a, 64 bits: case.json lists every file with its sum.
  std::uint64_t sum = 14695981039346656037ULL;
  for (const char byte : read_file(folder / kCaseFile, kMostJsonBytes))
    sum = (sum ^ static_cast<unsigned char>(byte)) * 1099511628211ULL;
  return std::to_string(sum);
}

std::vector<std::string> put_case(const fs::path& fresh, const fs::path& path) {
  std::vector<std::string> notes;
  if (fs::exists(path))
    for (const std::string& file : carry_over(path, fresh))
      notes.push_back("case.kept_changed " + (path / file).string());
  flush_tree(fresh);
  exchange_folders(fresh, path, kCaseFile);
  return notes;
}

bool save_case(const fs::path& given, const CaseState& state, const RunContext& context, SavedImage& saved,
               std::vector<std::string>* notes, const std::function<void()>& last_look) {
  const fs::path path = case_place(given);
  if (path.extension() != ".glisson")
    throw InputError(given.string(), "", "a case is a folder whose name ends in .glisson",
                     "Choose such a name");
  if (fs::exists(path) && !holds_case(path))
    throw InputError(given.string(), "", "exists and is not a case", "Choose another name");
  if (!fs::is_directory(path.parent_path()))
    throw FileError(given.string() + ": its folder does not exist. Create it or choose another.");
  sweep_leftovers(path.parent_path());
  const TemporaryFolder temporary(path.parent_path());
  const fs::path fresh = temporary.path() / path.filename();
  fs::create_directory(fresh);
  if (fs::exists(path)) fs::permissions(fresh, fs::status(path).permissions());
  const Parts taken_over = saved.take_over(state, path, fresh);
  auto document = write_parts({fresh, path, context}, state, taken_over);
  if (!document) return false;
  (*document)["files"] = list_files(fresh);
  write_json(fresh / kCaseFile, *document);
  verify(fresh, path, state, taken_over, context.part(0.85, 0.97));
  flush_tree(fresh);  // takes long; what follows cannot be taken back
  if (context.cancelled()) return false;
  SavedImage now;
  now.remember(state, fresh, path);
  if (last_look) last_look();
  const std::vector<std::string> told = put_case(fresh, path);
  saved = now;
  if (notes != nullptr) notes->insert(notes->end(), told.begin(), told.end());
  context.progress(1.0, "case.saved");
  return true;
}

bool save_case(const fs::path& path, const CaseState& state, const RunContext& context,
               std::vector<std::string>* notes) {
  SavedImage none;
  return save_case(path, state, context, none, notes);
}

Cancellable<CaseState> open_case(const fs::path& given, const RunContext& context,
                                 std::vector<std::string>* lost) {
  return read_case(given, {}, context, lost, {});
}

namespace {

Cancellable<CaseState> read_case(const fs::path& given, const fs::path& home, const RunContext& context,
                                 std::vector<std::string>* lost, const Known& known) {
  fs::path path = case_place(given);
  sweep_leftovers(path.parent_path());
  path = standing_folder(path, kCaseFile);
  if (!fs::exists(path)) throw FileError(given.string() + ": does not exist. Check the path.");
  if (!holds_case(path))
    throw InputError(given.string(), kCaseFile, "is missing: this folder is not a case",
                     "Choose a folder NAME.glisson");
  require_own_files(path);
  const json document = read_json(path / kCaseFile);
  const std::string file = (path / kCaseFile).string();
  try {
    if (document.at("format") != kFormat)
      throw InputError(file, "format", "is not a Glisson case", "Choose a folder NAME.glisson");
    if (document.at("version").get<int>() > kCaseFormatVersion)
      throw InputError(file, "version",
                       "is " + std::to_string(document.at("version").get<int>()) +
                           ", this program reads up to " + std::to_string(kCaseFormatVersion),
                       "Open it with a newer Glisson");
    CaseState state;
    state.path = fs::absolute(given).lexically_normal();
    CaseFolder folder{path, home.empty() ? path : home, context, lost, known.state != nullptr};
    const json& parts = document.at("parts");
    double done = 0.0;
    for (const Part part : all_parts()) {
      const auto entry = parts.find(part.code());
      if (entry == parts.end() || !part.type().is_saved()) continue;
      const double begun = done;
      done += reading_share(part);
      folder.context = context.part(begun, done);
      folder.context.progress(0.0, "case.read");
      if (known.parts.has(part))
        state.take(part, *known.state);
      else
        part.type().spec().load(state, *entry, folder);
      if (context.cancelled()) return {};
      if (!state.has(part)) continue;
      state.stamp(part) = read_stamp(path, *entry, part);
      free_of_left_out(path, parts, part, state);
    }
    if (lost != nullptr)
      for (const std::string& changed : changed_files(path, document, context))
        lost->push_back("case.changed_outside " + changed);
    if (context.cancelled()) return {};
    return state;
  } catch (const json::exception& failure) {
    throw InputError(file, "", std::string("is malformed (") + failure.what() + ")",
                     "Restore the case from a copy");
  }
}

}  // namespace

}  // namespace glisson::engine
