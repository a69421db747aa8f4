// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/import_labels.h"

#include "glisson/core/error.h"
#include "glisson/engine/parts/image.h"
#include "glisson/volume/io.h"
#include "label_steps.h"

namespace glisson::engine {
namespace {

/// What a file says of its labels, by the labels that they become.
Review review_in(const LabelFile& file, const LabelCodes& codes) {
  Review review;
  for (const LabelInfo& info : file.infos) {
    if (!codes.empty() && !codes.contains(info.code)) continue;  // it becomes background
    const ReviewState state = review_state(info.status);
    const auto [known, is_new] = review.emplace(codes.empty() ? info.code : codes.at(info.code), state);
    // Of several that become one label, all have to be looked at.
    if (!is_new) known->second = std::min(known->second, state);
  }
  std::erase_if(review, [](const auto& one) { return one.second == ReviewState::not_started; });
  return review;
}

}  // namespace

CommandTraits ImportLabels::traits() const {
  return {.code = "import_labels",
          .reads = {part::image},
          .writes = labels_and_review(),
          .notice = Notice::files};
}

Cancellable<Applied> ImportLabels::apply(const CaseState& state, const RunContext& context) const {
  context.progress(0.0, "labels.read");
  const LabelFile file = read_labels(path);
  if (state[part::image]) require_same_grid(file.voxels.grid(), state[part::image]->grid, path.string());
  if (context.cancelled()) return {};
  LabelMap labels = codes.empty() ? LabelMap{file.voxels, file.infos} : recode(file, codes, path.string());
  Applied applied{state};
  replace_labels(applied.state, std::move(labels), {kImportStep, 0, 0.0});
  put_review(applied.state, review_in(file, codes));
  report_labels(applied.state, applied.figures);
  if (!applied.figures.contains("label_parenchyma_ml"))
    throw InputError(path.string(), "labels", "none of them is the liver's parenchyma",
                     "Say which code means what with --codes FILE (see 'glisson model --help')");
  return applied;
}

}  // namespace glisson::engine
