// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glisson/editing/edit.h"
#include "glisson/ui/common/hand.h"

namespace glisson::ui {

/// How deep a lasso in a slice cuts.
enum class CutDepth { slice, slab, through };

/// Settings of all tools; each keeps its own while another is used.
struct EditSettings {
  Label label = structure::kParenchyma;  ///< that tools work on
  editing::EditableRegion region;        ///< `locked` included

  double brush_radius = 5e-3;  ///< metres
  bool ball = false;
  bool erase_any = false;  ///< not only `label`

  double low = 100.0, high = 300.0;  ///< threshold, Hounsfield units
  bool replace = false;

  editing::Scissors::Operation cut = editing::Scissors::Operation::erase_inside;
  CutDepth depth = CutDepth::slice;
  double slab = 10e-3;   ///< metres, whole thickness
  bool cut_any = false;  ///< erase any label

  double reach = 20e-3;              ///< grow, metres
  std::vector<Label> not_growing{};  ///< labels that stay as they are

  editing::Islands::Operation islands = editing::Islands::Operation::keep_largest;
  double smallest_ml = 1.0;

  bool holes_in_slices = false;

  editing::Smooth::Method smooth = editing::Smooth::Method::median;
  double smooth_radius = 3e-3;

  bool shrink = false;
  double margin = 3e-3;  ///< metres, positive

  scene::Plane between = scene::Plane::axial;  ///< interpolate between slices of this plane

  editing::Logical::Operation logical = editing::Logical::Operation::add;
  Label other = structure::kPortalVein;

  bool cut_branch_off = false;  ///< else a branch goes to the other tree

  bool operator==(const EditSettings&) const = default;
};
inline constexpr double kSmallestBrush = 0.5e-3, kLargestBrush = 50e-3;  ///< metres

/// Why a tool cannot be used now.
enum class EditObstacle { none, no_volume, label_locked, label_empty, other_empty, same_label, one_label };

}  // namespace glisson::ui
