// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/segment_by_network.h"

#include <algorithm>
#include <utility>

#include "found_labels.h"
#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/locks.h"
#include "glisson/network/label_network.h"
#include "glisson/segmentation/kept_notes.h"
#include "label_steps.h"

namespace glisson::engine {
namespace {

/// @param[out] tiles that the network has looked at.
Cancellable<FoundLabels> found(const SegmentByNetwork& command, const network::LabelSheet& sheet,
                               const CaseState& state, const RunContext& context, long& tiles) {
  auto labelled = network::label_by_network(*state[part::image], command.network, sheet, {command.locked},
                                            context, state[part::labels].get());
  if (!labelled) return {};
  tiles = labelled->tiles;
  segmentation::PartlyAnew anew;
  anew.is_kept = [&](Label label) {
    if (label == structure::kBackground) return state[part::labels] != nullptr;
    return !sheet.finds(label) || std::ranges::find(command.locked, label) != command.locked.end();
  };
  return FoundLabels{std::move(labelled->labels),
                     segmentation::with_kept_notes(told_of_labels(state), anew, std::move(labelled->notes))};
}

}  // namespace

std::set<Label> SegmentByNetwork::would_replace(const CaseState& state,
                                                const network::LabelSheet& sheet) const {
  std::set<Label> replaced = edited_by_hand(state);
  for (const Label label : locked) replaced.erase(label);
  std::erase_if(replaced, [&](Label label) { return !sheet.finds(label); });
  return replaced;
}

CommandTraits SegmentByNetwork::traits() const {
  return {.code = "segment_by_network",
          .reads = {part::image, part::labels, part::locks},
          .writes = labels_and_review(),
          .needs = {part::image}};
}

Cancellable<Applied> SegmentByNetwork::apply(const CaseState& state, const RunContext& context) const {
  const network::LabelSheet sheet = network::read_label_sheet(network);
  long tiles = 0;
  auto applied = put_found_labels(state, would_replace(state, sheet), over_hand_work, true,
                                  [&] { return found(*this, sheet, state, context, tiles); });
  if (applied) applied->figures["network_tiles"] = static_cast<double>(tiles);
  return applied;
}

}  // namespace glisson::engine
