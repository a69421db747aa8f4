// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "glisson/engine/parts/moments.h"

/// @file
/// A kept moment below a case's folder: moments/0007.json, moments/0007.jsonl (its overlay, as a line of a
/// track's frames.jsonl), moments/0007_left.png and moments/0007_right.png. The names come from the number
/// alone, so that no file can name another one.

namespace glisson::engine {

/// @param folder of the case. @param former where the same moment may be already: pictures that are the same
/// there become second names of those files. @throws FileError.
void write_moment(const std::filesystem::path& folder, const std::filesystem::path& former,
                  const KeptMoment& moment);
/// @throws FileError; InputError naming file and field: damaged, or of another number.
KeptMoment read_moment(const std::filesystem::path& folder, int number);
/// Whether two are the same but for what files round.
bool same_moment(const KeptMoment& a, const KeptMoment& b);

}  // namespace glisson::engine
