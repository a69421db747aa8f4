// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "glisson/patient/label_map.h"

namespace glisson::segmentation {

/// How labels were found in part anew.
struct PartlyAnew {
  /// Whether a structure is as it was; background: whether any is.
  std::function<bool(Label)> is_kept;
  /// Whether what was told then is a report on all labels, as segment() gives it.
  bool is_whole = false;
  /// Whether a former note, though of a structure that is kept, was looked into again; empty: none was.
  std::function<bool(const std::string& note)> is_answered = {};
};

/// What is told of such labels: what was told then, behind those notes of the former labels that hold still.
/// @param former of the former labels. What a whole report tells each time (volumes, borders, sides, the
///   image) is taken from that.
std::vector<std::string> with_kept_notes(const std::vector<std::string>& former, const PartlyAnew& anew,
                                         std::vector<std::string> told);

}  // namespace glisson::segmentation
