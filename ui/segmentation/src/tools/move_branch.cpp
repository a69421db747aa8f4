// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCoreApplication>

#include "glisson/editing/tools/reassign.h"
#include "glisson/ui/segmentation/window_tool.h"

namespace glisson::ui {
namespace {

struct BranchGoes {
  bool off = false;  ///< else to the other tree
  bool operator==(const BranchGoes&) const = default;
};

Foretold foretells(const editing::Tool& click) {
  const auto& moved = click.as<editing::ReassignBranch>();
  if (moved.to == structure::kBackground)
    return {QT_TRANSLATE_NOOP("EditTexts", "A click here cuts %1 ml off: %2."), {moved.label}};
  return {QT_TRANSLATE_NOOP("EditTexts", "A click here moves %1 ml: %2 → %3."), {moved.label, moved.to}};
}

/// It must move the voxel that the click is on: along a branch little changes.
bool stands_for(const editing::Tool& shown, const editing::Tool& click, const LabelMap& before,
                const LabelMap& after) {
  const auto &moves = shown.as<editing::ReassignBranch>(), &at = click.as<editing::ReassignBranch>();
  if (moves.label != at.label || moves.to != at.to) return false;
  const VolumeGrid& grid = before.voxels.grid();
  const Eigen::Vector3i v = grid.index_of(Point<CtFrame>(at.p_in_ct)).array().round().matrix().cast<int>();
  return grid.contains(v) && after.voxels.at(v) != before.voxels.at(v);
}

}  // namespace

const WindowTool& move_branch_window_tool() {
  static const WindowTool kTool = [] {
    WindowTool tool{"move_branch",
                    130,
                    'B',
                    QT_TRANSLATE_NOOP("EditTexts", "Move branch"),
                    {{"reassign_branch", QT_TRANSLATE_NOOP("EditTexts", "Move branch")},
                     {"reassign_branch.cut", QT_TRANSLATE_NOOP("EditTexts", "Cut branch off")}},
                    [](const EditSettings&) {
                      return QT_TRANSLATE_NOOP("EditTexts",
                                               "Click a vessel: what hangs on it beyond its thinnest place "
                                               "goes to the other tree. Ctrl does the other of the two.");
                    },
                    "click a branch of the portal or hepatic tree: what hangs on it beyond its thinnest "
                    "place goes to the other tree, or is cut off. What a click would move is hatched under "
                    "the pointer and named below the buttons"};
    tool.page = {choice_box("branch_goes", QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "The branch"),
                            {QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "goes to the other tree"),
                             QT_TRANSLATE_NOOP("glisson::ui::ToolPages", "is cut off")},
                            &BranchGoes::off)};
    tool.hand = [](const EditSettings&) { return Hand::point; };
    tool.at_pointer = WindowTool::AtPointer::branch;
    tool.works_on_label = [](const EditSettings&) { return false; };
    tool.click = [](const EditSettings& s, const ToolClick& at) -> std::optional<editing::Tool> {
      const bool portal = at.clicked == structure::kPortalVein;
      if (!portal && at.clicked != structure::kHepaticVeins) return std::nullopt;
      const Label other = portal ? structure::kHepaticVeins : structure::kPortalVein;
      const Label to = s.of<BranchGoes>().off != at.invert ? structure::kBackground : other;
      return editing::ReassignBranch{at.clicked, to, at.p.xyz};
    };
    tool.foretells = foretells;
    tool.stands_for = stands_for;
    return tool;
  }();
  return kTool;
}

}  // namespace glisson::ui
