// SPDX-License-Identifier: GPL-3.0-or-later
// Edits of the labels from a script: what the window's tools do, without it.
#include "case_argument.h"
#include "cli.h"
#include "commands.h"
#include "label_output.h"

#include "glisson/engine/commands/edit_labels.h"
#include "glisson/engine/commands/redo_labels.h"
#include "glisson/engine/commands/set_review.h"
#include "glisson/engine/commands/undo_labels.h"

namespace glisson::app {
namespace {

/// "portal_vein=approved".
engine::SetReview review_from(const QString& text) {
  const QStringList parts = text.split('=');
  const auto label = parts.size() == 2 ? structure_named(parts[0].toStdString()) : std::nullopt;
  const auto state = label ? value_in(kReviewCodes, parts[1].toStdString()) : std::nullopt;
  if (state) return {*label, *state};
  QStringList states;
  for (const auto& [code, known] : kReviewCodes) states << QLatin1String(code);
  throw UsageError(Cli::tr("--review %1: write STRUCTURE=STATE, such as portal_vein=approved; states are %2.")
                       .arg(text, states.join(QStringLiteral(", ")))
                       .toStdString());
}

}  // namespace

int run_edit(const QStringList& given) {
  Arguments arguments("edit", Cli::tr("Edits the labels by a script of the window's tools. Each edit is a "
                                      "step that can be undone in the window."));
  declare_case(arguments);
  arguments.option("script", Cli::tr("The edits (JSON, LPS mm)."), "FILE");
  arguments.option("undo", Cli::tr("Undo so many steps first."), "N", 0);
  arguments.option("redo", Cli::tr("Redo so many steps first, after those that are undone."), "N", 0);
  arguments.option("review", Cli::tr("How far a label has come: STRUCTURE=STATE, several with commas."),
                   "LIST");
  declare_label_output(arguments);
  if (!arguments.parse(given)) return 0;
  const int undone = arguments.integer("undo", 0, 100000), redone = arguments.integer("redo", 0, 100000);
  std::vector<engine::SetReview> reviews;
  for (const QString& text : arguments.value("review").split(',', Qt::SkipEmptyParts))
    reviews.push_back(review_from(text));
  std::vector<editing::Edit> edits;
  if (arguments.has("script")) edits = editing::read_edits(arguments.path("script"));
  if (edits.empty() && undone == 0 && redone == 0 && reviews.empty())
    throw UsageError(Cli::tr("Nothing to do: give --script, --undo, --redo or --review.").toStdString());
  const LabelOutput output(arguments);
  Session session(arguments);
  open_case(arguments, session);
  for (int n = 0; n < undone; ++n) session.post(engine::UndoLabels{});
  for (int n = 0; n < redone; ++n) session.post(engine::RedoLabels{});
  double changed = 0.0;
  for (const editing::Edit& edit : edits) {
    session.post(engine::EditLabels{edit});
    changed += session.figures["voxels_changed"];
  }
  session.figures["edits"] = static_cast<double>(edits.size());
  session.figures["voxels_changed"] = changed;
  for (const engine::SetReview& review : reviews) session.post(review);
  output.finish(session);
  return 0;
}

}  // namespace glisson::app
