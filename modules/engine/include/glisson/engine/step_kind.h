// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

#include "glisson/editing/edit.h"
#include "glisson/patient/label_map.h"

/// @file
/// What commands put into the labels' history besides the editor's tools. A step is read from a file by its
/// code alone: what its voxels are worth and what it is called is looked up here. A new kind is one file
/// below src/steps/.

namespace glisson::engine {

/// A kind of step that is no tool of the editor's.
struct StepKind {
  /// Who found the voxels that it changed.
  enum class Work {
    by_hand,            ///< a person
    grown,              ///< a machine made the labels anew, whatever a hand had corrected in them
    grown_around_hand,  ///< a machine, but for the voxels that a hand had corrected
    imported            ///< all labels came from elsewhere
  };
  std::string_view code;  ///< in histories and their files: "segment"
  Work work = Work::by_hand;
  const char* text = "";  ///< for translators in context EditTexts, on the undo button

  /// A step of this kind, done to one label, or to several (kBackground).
  editing::StepName name(Label label = structure::kBackground) const;
};

/// Makes a kind known that is not below src/steps/: define one of namespace scope beside it.
class RegisteredStepKind {
 public:
  explicit RegisteredStepKind(const StepKind& kind);
};

/// Every kind, by code.
const std::vector<const StepKind*>& step_kinds();
/// Steps of unknown kinds, as those of all tools, are a hand's: what they did is not replaced unasked.
StepKind::Work work_of(const editing::StepName& step);

}  // namespace glisson::engine
