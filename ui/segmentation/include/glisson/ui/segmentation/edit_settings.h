// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glisson/editing/edit.h"
#include "glisson/ui/common/hand.h"
#include "glisson/ui/segmentation/value_of_each.h"

namespace glisson::ui {

/// Settings of all tools; each keeps its own while another is used.
struct EditSettings {
  Label label = structure::kParenchyma;  ///< that tools work on
  editing::EditableRegion region;        ///< `locked` included

  // The brush, with which one tool paints and another erases.
  double brush_radius = 5e-3;  ///< metres
  bool ball = false;
  bool erase_any = false;  ///< not only `label`

  /// What one tool alone asks for: best the struct of its settings, as it comes from the editor.
  ValueOfEach own;

  template <class T>
  const T& of() const {
    return own.get<T>();
  }
  template <class T>
  T& of() {
    return own.get<T>();
  }

  bool operator==(const EditSettings&) const = default;
};
inline constexpr double kSmallestBrush = 0.5e-3, kLargestBrush = 50e-3;  ///< metres

/// How deep a lasso in a slice cuts.
enum class CutDepth { slice, slab, through };
/// What scissors ask for besides editing::Scissors.
struct Cut {
  CutDepth depth = CutDepth::slice;
  double slab = 10e-3;     ///< metres, whole thickness
  bool any_label = false;  ///< when it erases

  bool operator==(const Cut&) const = default;
};

/// Why a tool cannot be used now.
enum class EditObstacle {
  none,
  case_first,  ///< something of the case is not there: EditSession::why_not() says what
  replaced,    ///< other labels are on their way
  offered,     ///< a new segmentation waits for a decision, which an edit would let go
  label_locked,
  label_empty,
  other_empty,
  same_label,
  one_label
};

}  // namespace glisson::ui
