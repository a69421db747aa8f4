// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli.h"

/// @file
/// What sub-commands that change labels do with them: save the case, write them to a file, compare them with
/// an expert's.

namespace glisson::app {

/// Declares --labels-out, --truth and --truth-codes.
void declare_label_output(Arguments& arguments);

class LabelOutput {
 public:
  /// Looks at the arguments before the work. @throws UsageError, FileError.
  explicit LabelOutput(const Arguments& arguments);
  /// Saves and compares; the session is finished. @throws as Session::finish().
  void finish(Session& session) const;

 private:
  /// With the truth. @throws InputError it cannot be compared.
  void compare(Session& session) const;

  const Arguments& arguments_;
  LabelCodes truth_codes_;
};

}  // namespace glisson::app
