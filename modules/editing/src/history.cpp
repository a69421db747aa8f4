// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/editing/history.h"

#include <algorithm>
#include <set>

#include "glisson/core/error.h"

namespace glisson::editing {
namespace {

using BrickPointer = std::shared_ptr<const LabelVolume::Brick>;

constexpr std::size_t kBrickBytes = sizeof(LabelVolume::Brick);

/// The first changes and then the second, as one. Both are sorted by brick.
LabelChanges joined(const LabelChanges& first, const LabelChanges& second) {
  LabelChanges all;
  auto a = first.begin();
  auto b = second.begin();
  while (a != first.end() || b != second.end()) {
    if (b == second.end() || (a != first.end() && a->number < b->number)) {
      all.push_back(*a++);
    } else if (a == first.end() || b->number < a->number) {
      all.push_back(*b++);
    } else {
      all.push_back({a->number, a->before, b->after});
      ++a, ++b;
    }
  }
  return all;
}

bool same_info(const LabelInfo& a, const LabelInfo& b) {
  return a.code == b.code && a.name == b.name && a.terminology == b.terminology && a.colour == b.colour &&
         a.status == b.status;
}

}  // namespace

History History::with(StepName name, const LabelMap& before, const LabelMap& after,
                      std::uint64_t gesture) const {
  return with(
      Step{std::move(name), after.voxels.changes_since(before.voxels), before.infos, after.infos, gesture});
}

History History::with(Step step) const {
  History history = *this;
  const bool changed =
      !step.changes.empty() || !std::equal(step.infos_before.begin(), step.infos_before.end(),
                                           step.infos_after.begin(), step.infos_after.end(), same_info);
  if (!changed) return history;
  history.steps_.resize(history.done_);
  if (step.gesture != 0 && !history.steps_.empty() && history.steps_.back()->gesture == step.gesture) {
    const Step& last = *history.steps_.back();
    step.changes = joined(last.changes, step.changes);
    step.infos_before = last.infos_before;
    step.notes_before = last.notes_before;
    history.steps_.pop_back();
  }
  history.steps_.push_back(std::make_shared<const Step>(std::move(step)));
  history.done_ = history.steps_.size();
  history.keep_within_budget();
  return history;
}

const History::Step& History::undo_step() const {
  require(can_undo(), "there is a step to be undone");
  return *steps_[done_ - 1];
}

const History::Step& History::redo_step() const {
  require(can_redo(), "there is a step to be redone");
  return *steps_[done_];
}

std::pair<LabelMap, History> History::undo(const LabelMap& labels) const {
  const Step& step = undo_step();
  std::pair<LabelMap, History> answer{labels, *this};
  answer.first.voxels.apply(step.changes, true);
  answer.first.infos = step.infos_before;
  --answer.second.done_;
  return answer;
}

std::pair<LabelMap, History> History::redo(const LabelMap& labels) const {
  const Step& step = redo_step();
  std::pair<LabelMap, History> answer{labels, *this};
  answer.first.voxels.apply(step.changes, false);
  answer.first.infos = step.infos_after;
  ++answer.second.done_;
  return answer;
}

std::size_t History::bytes() const {
  std::set<const LabelVolume::Brick*> bricks;
  for (const auto& step : steps_)
    for (const LabelChange& change : step->changes)
      for (const BrickPointer* brick : {&change.before, &change.after})
        if (*brick) bricks.insert(brick->get());
  return kBrickBytes * bricks.size();
}

void History::keep_within_budget() {
  // From the newest back, until the budget is spent; what lies beyond is forgotten.
  std::set<const LabelVolume::Brick*> bricks;
  std::size_t kept = 0;
  while (kept < steps_.size()) {
    for (const LabelChange& change : steps_[steps_.size() - 1 - kept]->changes)
      for (const BrickPointer* brick : {&change.before, &change.after})
        if (*brick) bricks.insert(brick->get());
    if (kept > 0 && kBrickBytes * bricks.size() > budget_) break;
    ++kept;
  }
  const std::size_t forgotten = steps_.size() - kept;
  steps_.erase(steps_.begin(), steps_.begin() + static_cast<std::ptrdiff_t>(forgotten));
  done_ -= forgotten;
}

}  // namespace glisson::editing
