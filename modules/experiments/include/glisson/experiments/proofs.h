// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "glisson/atlas/atlas.h"
#include "glisson/core/json_file.h"
#include "glisson/core/run_context.h"
#include "glisson/experiments/aims.h"

/// @file
/// The proofs, one for each part of the way: what each is told, what it finds, and the page that says so.

namespace glisson::experiments {

/// What a person chooses. Each proof takes of it what it knows (Proof::takes) and leaves the rest.
struct ProofChoices {
  std::uint64_t seed = 1;
  std::filesystem::path data;     ///< folder of the real data; what is absent is left out
  std::filesystem::path clicks;   ///< folder of the clicks on it
  bool real_only = false;         ///< nothing in silico
  bool development_only = false;  ///< no validation patients
  bool quick = false;             ///< few trials
  bool looks = false;             ///< of registration: whether one more look helps, and nothing else
  bool long_films = false;        ///< of live: follows what hands do, too, and 3,000 frames
  /// Of registration: what this folder of a run that was cut short holds is kept. Empty: none.
  std::filesystem::path former;
  /// The atlas that comes with the program; called by the proof that needs it.
  std::function<std::shared_ptr<const atlas::Atlas>()> built_in;
};

/// What any proof finds.
struct Proven {
  Figures figures;  ///< flat, units in the names
  std::vector<std::string> notes;
  std::vector<std::string> absent;      ///< data that were not there, and what could not be tried
  std::vector<std::string> unused;      ///< data that were there, and that nothing was measured on
  std::vector<std::string> table;       ///< lines of fixed width, the first the heads; may be empty
  std::vector<std::string> page_table;  ///< the same without times
};

/// One part of the way, measured against what its figures should be.
struct Proof {
  const char* name;          ///< as in "glisson prove NAME"
  const char* title;         ///< of its page and in the help, English; marked for translators
  const char* introduction;  ///< of its page, English
  /// What the introduction ends with: whether limits were set on those who are measured. Null: nothing.
  std::string (*whom)(const ProofChoices& choices);
  const std::vector<Aim>& (*aims)();  ///< that it is measured against
  /// Of real-only, development-only, quick, looks, long and resume (ProofChoices::former) those that it
  /// takes.
  std::string_view takes;
  /// Minutes to hours. Leaves what is worth a look in `folder`, which exists. Empty: cancelled; what was
  /// finished is there.
  /// @throws InputError naming a choice that cannot be; Error of any stage.
  Cancellable<Proven> (*run)(const ProofChoices& choices, const std::filesystem::path& folder,
                             const RunContext& context);
};

/// All of them.
std::span<const Proof> proofs();
/// Null: there is none of that name.
const Proof* proof_named(std::string_view name);

/// The page on what a proof has found, with the command that measures it again.
ProofPage page_of(const Proof& proof, const ProofChoices& choices, const Proven& found);

/// The folder where a page goes: the wanted one if there is one, else into the checkout that `here` is the
/// root of. A page with gaps never takes the place of a whole one unasked. Empty: nowhere.
std::filesystem::path folder_for(const ProofPage& page, const std::optional<std::filesystem::path>& wanted,
                                 const std::filesystem::path& here);

}  // namespace glisson::experiments
