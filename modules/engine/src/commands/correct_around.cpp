// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/correct_around.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "found_labels.h"
#include "glisson/core/error.h"
#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/locks.h"
#include "glisson/segmentation/kept_notes.h"
#include "label_steps.h"
#include "steps/correct_around.h"

namespace glisson::engine {
namespace {

/// What all clicks together have made of the labels.
struct Corrected {
  LabelMap labels;
  long changed = 0;
  double reach_mm = 0.0;
  std::vector<std::string> notes;
};

/// One click after the other.
Cancellable<Corrected> corrected(const CorrectAround& command, const CaseState& state,
                                 const RunContext& context) {
  Corrected all{*state[part::labels], 0, 0.0, {}};
  const std::vector<Label> locked = with_locks(command.locked, state);
  const std::size_t count = command.clicks.size() + command.grown.size();
  for (std::size_t n = 0; n < count; ++n) {
    const auto at = static_cast<double>(n), of = static_cast<double>(count);
    const RunContext here = context.part(at / of, (at + 1.0) / of);
    const Image& image = *state[part::image];
    auto one =
        n < command.clicks.size()
            ? segmentation::correct_around(image, all.labels, command.seeds, command.clicks[n], locked, here)
            : segmentation::grow_around(image, all.labels, command.seeds,
                                        command.grown[n - command.clicks.size()], locked, here);
    if (!one) return {};
    all.labels = std::move(one->labels);
    all.changed += one->voxels_changed;
    all.reach_mm = std::max(all.reach_mm, one->reach_mm);
    all.notes.insert(all.notes.end(), one->notes.begin(), one->notes.end());
  }
  return all;
}

Figures figures_of(const Corrected& made) {
  const auto changed = static_cast<double>(made.changed);
  return {{"voxels_changed", changed},
          {"changed_ml", 1e-3 * changed * made.labels.voxels.grid().voxel_volume_mm3()},
          {"reach_mm", made.reach_mm}};
}

/// The one that a person has worked on; background: more than one, or what is not liver, of which any label
/// may have lost voxels.
Label label_of(const CorrectAround& command) {
  std::set<Label> worked_on;
  for (const segmentation::Click& click : command.clicks)
    worked_on.insert(click.is_liver ? structure::kParenchyma : structure::kBackground);
  for (const segmentation::StructureClick& click : command.grown) worked_on.insert(click.structure);
  return worked_on.size() == 1 ? *worked_on.begin() : Label{structure::kBackground};
}

/// Those of before that hold still, and what was told of the clicks.
FoundLabels with_notes(const CaseState& state, const CorrectAround& command, Corrected made) {
  std::set<Label> grown;
  for (const segmentation::StructureClick& click : command.grown) grown.insert(click.structure);
  segmentation::PartlyAnew anew;
  anew.is_kept = [&](Label label) { return !grown.contains(label); };
  anew.is_answered = [&](const std::string& note) { return segmentation::is_settled(note, made.labels); };
  std::vector<std::string> notes = segmentation::with_kept_notes(
      kept_notes(state), anew, segmentation::with_places(std::move(made.notes), command.seeds));
  return {std::move(made.labels), std::move(notes)};
}

/// Where nothing changes the labels stay the same edition: a model made of them is not out of date.
Applied put(const CaseState& state, const CorrectAround& command, Corrected made) {
  Applied applied{state, figures_of(made), made.notes};
  if (made.changed > 0)
    put_edited_labels(applied.state, *state[part::labels], with_notes(state, command, std::move(made)),
                      step::correct_around.name(label_of(command)), 0);
  if (applied.state[part::statistics]) applied.figures.merge(label_figures(applied.state));
  return applied;
}

/// Over lesions that a hand has drawn.
Applied put_asking(const CaseState& state, const CorrectAround& command, const std::set<Label>& drawn,
                   Corrected made) {
  Figures figures = figures_of(made);
  std::vector<std::string> told = made.notes;
  SegmentationOffer offer = offer_of(state, drawn, true, with_notes(state, command, std::move(made)));
  offer.clicked = step::correct_around.name(label_of(command));
  Applied applied = put_offer(state, std::move(offer), command.over_hand_work);
  applied.notes = std::move(told);
  if (applied.state[part::offer])
    for (auto& [name, value] : figures) value = 0.0;
  applied.figures.merge(figures);
  return applied;
}

/// @param drawn see CorrectAround::would_replace().
void require_asked(const CaseState& state, const CorrectAround& command, const std::set<Label>& drawn) {
  if (command.over_hand_work == OverHandWork::offer && state[part::offer])
    throw InputError("segmentation", "", "waits for a decision", "Decide about it first");
  if (!drawn.empty() && command.over_hand_work == OverHandWork::refuse) throw hand_work_error(drawn);
}

}  // namespace

std::set<Label> CorrectAround::would_replace(const CaseState& state) const {
  const std::set<Label> drawn = drawn_by_hand(state);
  std::set<Label> replaced;
  for (const segmentation::StructureClick& click : grown)
    if (is_lesion(click.structure) && drawn.contains(click.structure)) replaced.insert(click.structure);
  return replaced;
}

CommandTraits CorrectAround::traits() const {
  return {.code = "correct_around",
          .reads = labels_and_review() | Parts{part::image, part::locks},
          .writes = labels_and_review(),
          .needs = {part::image, part::labels},
          .notice = Notice::quiet};
}

Cancellable<Applied> CorrectAround::apply(const CaseState& state, const RunContext& context) const {
  require_labels_fit_image(state);
  const std::set<Label> drawn = would_replace(state);
  require_asked(state, *this, drawn);
  auto made = corrected(*this, state, context);
  if (!made) return {};
  if (drawn.empty() || made->changed == 0) return put(state, *this, std::move(*made));
  return put_asking(state, *this, drawn, std::move(*made));
}

}  // namespace glisson::engine
