// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/segmentation/edit_texts.h"

#include <QCoreApplication>
#include <QHash>
#include <QStringList>
#include <algorithm>
#include <cmath>
#include <string>

#include "glisson/engine/step_kind.h"
#include "glisson/ui/common/texts.h"

namespace glisson::ui {
namespace {

/// Context of these words for translators.
class EditTexts {
  Q_DECLARE_TR_FUNCTIONS(EditTexts)
 public:
  static QString tool(EditTool tool) { return tool == nullptr ? tr("No tool") : tr(tool->name); }
  static QString hint(EditTool tool, const EditSettings& settings) {
    return tool == nullptr ? tr("Choose a label and a tool.") : tr(tool->hint(settings));
  }
  static QString foretold(const Foretold& foretold, const QString& ml) {
    QString text = tr(foretold.text).arg(ml);
    for (const Label label : foretold.labels) text = text.arg(structure_text(label));
    return text;
  }
  static QString obstacle(EditObstacle obstacle) {
    switch (obstacle) {
      case EditObstacle::none:
      case EditObstacle::case_first:  // the engine's words
        break;
      case EditObstacle::replaced:
        return tr("New labels are on their way: wait for them, or cancel that.");
      case EditObstacle::offered:
        return tr("A new segmentation waits for your decision.");
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
  static QHash<QString, QString> steps(const EditTools& tools) {
    QHash<QString, QString> texts;
    for (const engine::StepKind* kind : engine::step_kinds())
      texts.insert(QString::fromStdString(std::string(kind->code)), tr(kind->text));
    for (const EditTool tool : tools)
      for (const WindowTool::Step& step : tool->steps) texts.insert(step.code, tr(step.text));
    return texts;
  }
  static QString millimetres(double metres) {
    const double tenths = std::round(1e4 * metres);
    return tr("%1 mm").arg(0.1 * tenths, 0, 'f', std::fmod(tenths, 10.0) == 0.0 ? 0 : 1);
  }
};

}  // namespace

QString tool_text(EditTool tool) { return EditTexts::tool(tool); }
QString tool_hint(EditTool tool, const EditSettings& settings) { return EditTexts::hint(tool, settings); }
QString foretold_text(EditTool tool, const editing::Tool& click, const QString& ml) {
  return tool != nullptr && tool->foretells ? EditTexts::foretold(tool->foretells(click), ml) : QString();
}
QString obstacle_text(EditObstacle obstacle) { return EditTexts::obstacle(obstacle); }
QString review_text(ReviewState state) { return EditTexts::review(state); }

bool knows_step(const std::string& code) {
  return EditTexts::steps(edit_tools()).contains(QString::fromStdString(code));
}

QString step_text(const editing::StepName& step, const EditTools& tools) {
  QStringList parts = {
      EditTexts::steps(tools).value(QString::fromStdString(step.code), readable_code(step.code))};
  // A brush is known by its diameter, all else by its radius or distance.
  const bool brush = std::ranges::any_of(tools, [&](EditTool tool) {
    return tool->hand(EditSettings()) == Hand::brush &&
           std::ranges::any_of(tool->steps, [&](const auto& one) { return step.code == one.code; });
  });
  if (step.size > 0.0) parts << EditTexts::millimetres(brush ? 2.0 * step.size : step.size);
  if (step.label != structure::kBackground) parts << structure_text(step.label);
  return parts.join(QStringLiteral(", "));
}

}  // namespace glisson::ui
