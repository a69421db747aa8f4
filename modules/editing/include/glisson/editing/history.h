// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "glisson/editing/edit.h"
#include "glisson/patient/label_map.h"

namespace glisson::editing {

/// Steps that can be undone and redone, kept as the bricks that each changed. A value: copies share bricks.
class History {
 public:
  static constexpr std::size_t kDefaultBudget = std::size_t{256} << 20U;
  /// @param budget bytes of bricks that steps may hold; the oldest steps are forgotten beyond it, and the
  ///   newest is always kept.
  explicit History(std::size_t budget = kDefaultBudget) : budget_(budget) {}

  /// One entry of the undo list.
  struct Step {
    StepName name;
    LabelChanges changes;
    std::vector<LabelInfo> infos_before, infos_after;  ///< of the whole label map
    std::uint64_t gesture = 0;  ///< steps of one gesture are joined into one; 0: belongs to none
    std::vector<std::string> notes_before = {}, notes_after = {};  ///< what is told of the labels
  };

  /// The history after a step from `before` to `after`; what could be redone is forgotten. A step of the same
  /// gesture (not 0) as the last one is joined to it. @pre one grid.
  History with(StepName name, const LabelMap& before, const LabelMap& after, std::uint64_t gesture = 0) const;
  /// The same for whoever has compared the two already.
  /// @pre `step.changes` are after.voxels.changes_since(before.voxels).
  History with(Step step) const;

  bool can_undo() const { return done_ > 0; }
  bool can_redo() const { return done_ < steps_.size(); }
  const StepName& undo_name() const { return undo_step().name; }
  const StepName& redo_name() const { return redo_step().name; }
  /// The step that would be undone or redone. @pre can_undo(), can_redo().
  const Step& undo_step() const;
  const Step& redo_step() const;
  /// The labels one step back or forth, and the history then. @pre can_undo(), can_redo(); `labels` are those
  /// of the last step.
  std::pair<LabelMap, History> undo(const LabelMap& labels) const;
  std::pair<LabelMap, History> redo(const LabelMap& labels) const;

  /// Oldest first; the first `done()` of them are done.
  const std::deque<std::shared_ptr<const Step>>& steps() const { return steps_; }
  std::size_t done() const { return done_; }
  /// Of the bricks that steps hold, each counted once.
  std::size_t bytes() const;

 private:
  friend History read_history(const std::filesystem::path& folder, const LabelVolume& labels);
  void keep_within_budget();

  std::size_t budget_;
  std::deque<std::shared_ptr<const Step>> steps_;
  std::size_t done_ = 0;
};

/// Writes `steps.json` and the bricks (`bricks.nrrd`: 32 x 32 x 32 x n, gzip) into a folder that exists.
void write_history(const std::filesystem::path& folder, const History& history);
/// @throws InputError when any of its steps, done or undone, does not belong to the labels, or it is damaged.
History read_history(const std::filesystem::path& folder, const LabelVolume& labels);

}  // namespace glisson::editing
