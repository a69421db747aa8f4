// SPDX-License-Identifier: GPL-3.0-or-later
#include "case_argument.h"

#include "glisson/engine/commands/open_case.h"
#include "glisson/engine/commands/save_case.h"

namespace glisson::app {

void declare_case(Arguments& arguments) {
  arguments.option("case", Cli::tr("The case's folder, NAME.glisson."), "CASE");
}

void open_case(const Arguments& arguments, Session& session) {
  session.post(engine::OpenCase{arguments.required_path("case")});
}

void save_case(const Arguments& arguments, Session& session) {
  session.post(engine::SaveCase{arguments.required_path("case")});
  session.texts["case"] = arguments.path("case").string();
}

/// What the option's file says that foreign codes mean; nothing without the option.
LabelCodes codes_of(const Arguments& arguments, const QString& option) {
  return arguments.has(option) ? read_label_codes(arguments.path(option)) : LabelCodes{};
}

}  // namespace glisson::app
