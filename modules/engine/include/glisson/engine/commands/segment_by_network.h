// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <set>
#include <vector>

#include "glisson/engine/command.h"
#include "glisson/engine/hand_edits.h"
#include "glisson/network/label_sheet.h"

namespace glisson::engine {

/// Labels by a person's own network. Labels that the network does not know, and those that are locked, stay;
/// what a hand has corrected is replaced only when that was said.
struct SegmentByNetwork {
  std::filesystem::path network;  ///< ONNX, its sheet beside it (network::read_label_sheet)
  std::vector<Label> locked;
  OverHandWork over_hand_work = OverHandWork::refuse;

  /// Labels that a hand has corrected and that would be found anew.
  std::set<Label> would_replace(const CaseState& state, const network::LabelSheet& sheet) const;
  CommandTraits traits() const;
  /// `network_tiles` in the figures; what would change of the corrected labels is told there, too.
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
