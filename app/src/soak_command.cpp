// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli.h"
#include "commands.h"
#include "exit_code.h"
#include "glisson/core/files.h"
#include "glisson/experiments/soak.h"
#include "live_overlay.h"

namespace glisson::app {

int run_soak(const QStringList& given) {
  experiments::SoakOptions options;
  Arguments arguments("soak",
                      Cli::tr("Does the same over and over, frames, opening and saving, edits with undo, "
                              "and looks whether memory, file descriptors and threads stay what they are."));
  arguments.option("case", Cli::tr("A case with a video and a registration; else one is made."), "CASE");
  arguments.option("frames", Cli::tr("Frames to follow and draw."), "N", QString::number(options.frames));
  arguments.option("opens", Cli::tr("Times to open and save the case."), "N", options.opens);
  arguments.option("edits", Cli::tr("Edits with their undo."), "N", options.edits);
  arguments.option("kills",
                   Cli::tr("Times to kill the program at work (import, save, record) and look what is left."),
                   "N", options.kills);
  arguments.option("page", Cli::tr("Also write the figures here, as a page."), "FILE.md");
  if (!arguments.parse(given)) return 0;
  options.patient = arguments.path("case");
  options.frames = arguments.integer("frames", 0, 100000000);
  options.opens = arguments.integer("opens", 0, 1000000);
  options.edits = arguments.integer("edits", 0, 10000000);
  options.kills = arguments.integer("kills", 0, 100000);
  options.program = QCoreApplication::applicationFilePath().toStdString();
  if (arguments.has("page")) arguments.output_file("page", {".md"});
  const TemporaryFolder folder;
  Session session(arguments);
  const auto result = experiments::soak(options, folder.path(), overlay_hook(), session.context());
  if (!result) throw Interrupted();
  session.figures = result->figures;
  session.finish();
  say(QString::fromStdString(result->page));
  if (arguments.has("page")) write_file_atomically(arguments.path("page"), result->page);
  if (!result->complete) throw Interrupted();
  return result->passed ? kDone : kFailed;
}

}  // namespace glisson::app
