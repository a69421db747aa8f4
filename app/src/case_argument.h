// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli.h"

/// @file
/// The case that a sub-command works on.

namespace glisson::app {

/// Declares --case.
void declare_case(Arguments& arguments);
/// @throws UsageError --case is absent, Error it cannot be read.
void open_case(const Arguments& arguments, Session& session);
/// The same where there is one; else it is looked, before the work, whether one can stand there.
/// @throws UsageError, FileError as Arguments::output_file().
void open_case_if_there(const Arguments& arguments, Session& session);
void save_case(const Arguments& arguments, Session& session);

/// What the option's file says that foreign codes mean; nothing without the option.
LabelCodes codes_of(const Arguments& arguments, const QString& option);

}  // namespace glisson::app
