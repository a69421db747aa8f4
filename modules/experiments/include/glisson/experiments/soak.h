// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "glisson/core/json_file.h"
#include "glisson/core/run_context.h"
#include "glisson/engine/case_state.h"
#include "glisson/patient/picture.h"
#include "glisson/patient/registration.h"

namespace glisson::experiments {

/// How often each kind of work is done.
struct SoakOptions {
  /// A case with a model; for frames with a video and a registration, too. Empty: one is made of the
  /// synthetic patient.
  std::filesystem::path patient;
  int frames = 100000;  ///< of the case's film, followed and drawn
  int opens = 1000;     ///< with a save each
  int edits = 1000;     ///< with their undo
  int kills = 0;        ///< of the program at work, see kill_trial.h
  /// `glisson`, to be killed. Only for `kills`.
  std::filesystem::path program;

  /// @throws InputError naming the option.
  void validate() const;
};

/// How frames are drawn; the experiment knows no renderer. May be empty: they are only followed then.
using DrawOverlay = std::function<Picture(const engine::CaseState&, const StereoFrame&, const OverlayFrame&)>;

/// What a process used over hours of work, and what kills left.
struct SoakResult {
  Figures figures;        ///< `soak_...`, `kill_...`, and those of the engine's commands
  std::string page;       ///< the same in Markdown
  bool complete = false;  ///< false: it was interrupted, and this is what was done until then
  bool passed = false;    ///< complete, all flat, and nothing broken by a kill
};

/// The same work over and over: what a process uses must not grow with it. Long.
/// @param folder an existing, empty one for what is made on the way. @return empty when cancelled before a
/// first sample was taken.
/// @throws InputError a part that a kind of work needs is missing; Error of any stage; FileError.
Cancellable<SoakResult> soak(const SoakOptions& options, const std::filesystem::path& folder,
                             const DrawOverlay& draw, const RunContext& context);

}  // namespace glisson::experiments
