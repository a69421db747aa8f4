// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/segmentation/edit_texts.h"

#include <QCoreApplication>
#include <QHash>
#include <QStringList>
#include <cmath>

#include "glisson/ui/common/texts.h"

namespace glisson::ui {
namespace {

/// Context of these words for translators.
class EditTexts {
  Q_DECLARE_TR_FUNCTIONS(EditTexts)
 public:
  static QString tool(EditTool tool) {
    switch (tool) {
      case EditTool::none:
        break;
      case EditTool::paint:
        return tr("Paint");
      case EditTool::erase:
        return tr("Erase");
      case EditTool::scissors:
        return tr("Scissors");
      case EditTool::threshold:
        return tr("Threshold");
      case EditTool::grow:
        return tr("Grow from seeds");
      case EditTool::level_tracing:
        return tr("Level tracing");
      case EditTool::islands:
        return tr("Islands");
      case EditTool::fill_holes:
        return tr("Fill holes");
      case EditTool::smooth:
        return tr("Smooth");
      case EditTool::margin:
        return tr("Margin");
      case EditTool::interpolate:
        return tr("Interpolate between slices");
      case EditTool::logical:
        return tr("Logical");
      case EditTool::move_branch:
        return tr("Move branch");
    }
    return tr("No tool");
  }
  static QString hint(EditTool tool, const EditSettings& settings) {
    switch (tool) {
      case EditTool::none:
        return tr("Choose a label and a tool.");
      case EditTool::paint:
        return tr("Drag in a slice. Ctrl erases. Shift + wheel: size.");
      case EditTool::erase:
        return tr("Drag in a slice. Ctrl paints. Shift + wheel: size.");
      case EditTool::scissors:
        return tr("Draw around it, in a slice or in 3D. Ctrl fills instead of erasing, and the other way.");
      case EditTool::threshold:
        return tr("Everything between two intensities becomes the label.");
      case EditTool::grow:
        return tr(
            "What is labelled grows into what is not, along like intensities. Paint a few strokes of each "
            "label first.");
      case EditTool::level_tracing:
        return tr("Click where the region of like intensity ends. Ctrl erases.");
      case EditTool::islands:
        return islands_by_click(settings) ? tr("Click an island of the label. Ctrl does the opposite.")
                                          : tr("Separate pieces of the label.");
      case EditTool::fill_holes:
        return tr("Closes what the label encloses.");
      case EditTool::smooth:
        return settings.smooth == editing::Smooth::Method::joint
                   ? tr("All labels at once, without gaps between them.")
                   : tr("Evens the label's surface.");
      case EditTool::margin:
        return tr("Grows or shrinks the label by a distance.");
      case EditTool::interpolate:
        return tr("Paint the label in some slices; those between are filled.");
      case EditTool::logical:
        return tr("Combines two labels.");
      case EditTool::move_branch:
        return tr(
            "Click a vessel: what hangs on it beyond its thinnest place goes to the other tree. Ctrl does "
            "the "
            "other of the two.");
    }
    return {};
  }
  static QString obstacle(EditObstacle obstacle) {
    switch (obstacle) {
      case EditObstacle::none:
        break;
      case EditObstacle::no_volume:
        return tr("Open a CT first.");
      case EditObstacle::label_locked:
        return tr("The label is locked.");
      case EditObstacle::label_empty:
        return tr("The label is empty.");
      case EditObstacle::other_empty:
        return tr("The other label is empty.");
      case EditObstacle::same_label:
        return tr("Choose another second label.");
      case EditObstacle::one_label:
        return tr("Two labels or more must grow.");
    }
    return {};
  }
  static QString review(ReviewState state) {
    switch (state) {
      case ReviewState::not_started:
        return tr("Not started");
      case ReviewState::in_progress:
        return tr("In progress");
      case ReviewState::to_review:
        return tr("To review");
      case ReviewState::approved:
        return tr("Approved");
    }
    return {};
  }
  static QHash<QString, QString> steps() {
    return {{"paint", tr("Paint")},
            {"erase", tr("Erase")},
            {"threshold", tr("Threshold")},
            {"scissors.fill_inside", tr("Scissors: fill inside")},
            {"scissors.erase_inside", tr("Scissors: erase inside")},
            {"scissors.erase_outside", tr("Scissors: erase outside")},
            {"grow_from_seeds", tr("Grow from seeds")},
            {"level_tracing", tr("Level tracing")},
            {"level_tracing.erase", tr("Level tracing: erase")},
            {"islands.keep_largest", tr("Islands: keep largest")},
            {"islands.remove_small", tr("Islands: remove small")},
            {"islands.keep_clicked", tr("Islands: keep clicked")},
            {"islands.remove_clicked", tr("Islands: remove clicked")},
            {"islands.split", tr("Islands: split")},
            {"fill_holes", tr("Fill holes")},
            {"smooth.median", tr("Smooth: median")},
            {"smooth.closing", tr("Smooth: closing")},
            {"smooth.opening", tr("Smooth: opening")},
            {"smooth.joint", tr("Smooth: joint")},
            {"margin.grow", tr("Margin: grow")},
            {"margin.shrink", tr("Margin: shrink")},
            {"interpolate_slices", tr("Interpolate between slices")},
            {"logical.copy", tr("Logical: copy")},
            {"logical.add", tr("Logical: add")},
            {"logical.subtract", tr("Logical: subtract")},
            {"logical.intersect", tr("Logical: intersect")},
            {"logical.invert", tr("Logical: invert")},
            {"logical.clear", tr("Logical: clear")},
            {"logical.fill", tr("Logical: fill")},
            {"reassign_branch", tr("Move branch")},
            {"reassign_branch.cut", tr("Cut branch off")},
            {"segment", tr("Segment")},
            {"import_labels", tr("Import labels")}};
  }
  static QString millimetres(double metres) {
    const double tenths = std::round(1e4 * metres);
    return tr("%1 mm").arg(0.1 * tenths, 0, 'f', std::fmod(tenths, 10.0) == 0.0 ? 0 : 1);
  }
};

}  // namespace

QString tool_text(EditTool tool) { return EditTexts::tool(tool); }
QString tool_hint(EditTool tool, const EditSettings& settings) { return EditTexts::hint(tool, settings); }
QString obstacle_text(EditObstacle obstacle) { return EditTexts::obstacle(obstacle); }
QString review_text(ReviewState state) { return EditTexts::review(state); }

bool knows_step(const std::string& code) { return EditTexts::steps().contains(QString::fromStdString(code)); }

QString step_text(const editing::StepName& step) {
  QStringList parts = {EditTexts::steps().value(QString::fromStdString(step.code), readable_code(step.code))};
  // A brush is known by its diameter, all else by its radius or distance.
  const bool brush = step.code == "paint" || step.code == "erase";
  if (step.size > 0.0) parts << EditTexts::millimetres(brush ? 2.0 * step.size : step.size);
  if (step.label != structure::kBackground) parts << structure_text(step.label);
  return parts.join(QStringLiteral(", "));
}

}  // namespace glisson::ui
