// SPDX-License-Identifier: GPL-3.0-or-later
#include "case_argument.h"

#include "glisson/engine/commands/open_case.h"
#include "glisson/engine/commands/save_case.h"

namespace glisson::app {

void declare_case(Arguments& arguments) {
  arguments.option("case", Cli::tr("The case's folder, NAME.glisson."), "CASE");
}

void open_case(const Arguments& arguments, Session& session) {
  // The modules know what lies in it by the names of its parts.
  for (const char* part : {"case", "image", "labels", "seeds", "regions", "calibration"})
    session.call(part, arguments.required_path("case").string());
  session.post(engine::OpenCase{arguments.required_path("case"), engine::OpenCase::Access::write});
}

void open_case_if_there(const Arguments& arguments, Session& session) {
  if (std::filesystem::exists(arguments.required_path("case")))
    open_case(arguments, session);
  else if (!arguments.value("case").endsWith(QLatin1Char('/')))  // saving takes that for the folder's name
    arguments.output_file("case", {".glisson"});
}

void save_case(const Arguments& arguments, Session& session) {
  const std::filesystem::path wanted = arguments.required_path("case");
  // Only what was opened here: a case that somebody else has put there meanwhile is not replaced.
  session.post(engine::SaveCase{wanted});
  const std::filesystem::path& saved = session.state().path;
  if (saved != wanted)
    throw FileError(wanted.string() +
                    ": others have saved it meanwhile, so that it stays as they left it; this run's is " +
                    saved.string() + ". Compare the two.");
  session.texts["case"] = wanted.string();
}

/// What the option's file says that foreign codes mean; nothing without the option.
LabelCodes codes_of(const Arguments& arguments, const QString& option) {
  return arguments.has(option) ? read_label_codes(arguments.path(option)) : LabelCodes{};
}

}  // namespace glisson::app
