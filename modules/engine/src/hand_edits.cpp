// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/hand_edits.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <memory>

#include "glisson/engine/parts/labels.h"
#include "glisson/engine/step_kind.h"
#include "label_steps.h"
#include "steps/correct_around.h"

namespace glisson::engine {
namespace {

using Step = editing::History::Step;

/// What the steps did, the newest first; what was undone is left out, and what lies before an import.
struct Walk {
  std::function<void(const Step& step)> grown = {};
  /// @param labels that the hand corrected, without those that growth has made anew since
  std::function<void(const Step& step, const std::set<Label>& labels)> by_hand = {};

  void over(const editing::History& history) const {
    std::set<Label> renewed;
    for (std::size_t n = history.done(); n > 0; --n) {
      const Step& step = *history.steps()[n - 1];
      const StepKind::Work work = work_of(step.name);
      if (work == StepKind::Work::imported) break;
      if (work != StepKind::Work::by_hand && grown) grown(step);
      if (work == StepKind::Work::grown_around_hand) continue;
      const std::set<Label> labels = step.name.label != structure::kBackground
                                         ? std::set<Label>{step.name.label}
                                         : labels_touched(step.changes);
      std::set<Label> left;
      std::set_difference(labels.begin(), labels.end(), renewed.begin(), renewed.end(),
                          std::inserter(left, left.end()));
      if (work == StepKind::Work::grown)
        renewed.insert(labels.begin(), labels.end());
      else if (!left.empty())
        by_hand(step, left);
    }
  }
};

/// Marks of voxels, in bricks that are made when they are needed.
class Marks {
 public:
  LabelVolume::Brick& in(std::size_t brick) {
    auto& marks = bricks_[brick];
    if (!marks) marks = std::make_shared<LabelVolume::Brick>();
    return *marks;
  }
  bool has(std::size_t brick, std::size_t voxel) const {
    const auto found = bricks_.find(brick);
    return found != bricks_.end() && (*found->second)[voxel] != 0;
  }
  LabelVolume on(const VolumeGrid& grid) const {
    LabelVolume volume(grid);
    for (const auto& [number, brick] : bricks_) volume.set_brick(number, brick);
    return volume;
  }

 private:
  std::map<std::size_t, std::shared_ptr<LabelVolume::Brick>> bricks_;
};

/// Calls `changed(brick, voxel, before, after)` for each voxel that a step changed.
template <class Changed>
void each_voxel(const Step& step, const Changed& changed) {
  for (const LabelChange& change : step.changes)
    for (std::size_t i = 0; i < LabelVolume::Brick().size(); ++i) {
      const Label before = change.before ? (*change.before)[i] : Label{0},
                  after = change.after ? (*change.after)[i] : Label{0};
      if (before != after) changed(change.number, i, before, after);
    }
}

}  // namespace

std::set<Label> edited_by_hand(const CaseState& state) {
  std::set<Label> edited;
  if (!state[part::history]) return edited;
  Walk walk;
  walk.by_hand = [&](const Step&, const std::set<Label>& labels) {
    edited.insert(labels.begin(), labels.end());
  };
  walk.over(*state[part::history]);
  return edited;
}

std::set<Label> drawn_by_hand(const CaseState& state) {
  std::set<Label> drawn, found_anew;
  if (!state[part::history]) return drawn;
  Walk walk;
  walk.by_hand = [&](const Step& step, const std::set<Label>& labels) {
    if (step.name.code != step::correct_around.code)
      std::set_difference(labels.begin(), labels.end(), found_anew.begin(), found_anew.end(),
                          std::inserter(drawn, drawn.end()));
    else if (is_lesion(step.name.label))
      found_anew.insert(step.name.label);
  };
  walk.over(*state[part::history]);
  return drawn;
}

LabelVolume hand_corrected(const CaseState& state) {
  require(state[part::labels] != nullptr, "corrections by hand are those of labels");
  const VolumeGrid& grid = state[part::labels]->voxels.grid();
  if (!state[part::history]) return LabelVolume(grid);
  Marks hand, grown;
  Walk walk;
  walk.grown = [&](const Step& step) {
    each_voxel(step, [&](std::size_t brick, std::size_t i, Label, Label) { grown.in(brick)[i] = 1; });
  };
  walk.by_hand = [&](const Step& step, const std::set<Label>& labels) {
    const bool of_one = step.name.label != structure::kBackground;
    each_voxel(step, [&](std::size_t brick, std::size_t i, Label before, Label after) {
      const bool counts = of_one || labels.contains(before) || labels.contains(after);
      if (counts && !grown.has(brick, i)) hand.in(brick)[i] = 1;
    });
  };
  walk.over(*state[part::history]);
  return hand.on(grid);
}

InputError hand_work_error(const std::set<Label>& labels) {
  return {"labels", structure_names(labels), "was corrected by hand and would be replaced",
          "Lock it (--lock), keep what was corrected (--keep-edited), or allow it (--replace-edited)"};
}

}  // namespace glisson::engine
