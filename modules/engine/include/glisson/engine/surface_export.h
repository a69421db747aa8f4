// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "glisson/core/run_context.h"
#include "glisson/engine/case_state.h"

namespace glisson::engine {

/// Endings of the formats that surfaces leave in: ".stl", ".ply", ".obj", ".vtp".
const std::vector<std::string>& surface_endings();

/// Surfaces in a folder that have names by which write_case_surfaces() may write over them, in their order by
/// name. Empty: there are none, or no such folder.
std::vector<std::filesystem::path> surfaces_in(const std::filesystem::path& folder,
                                               const std::string& ending);

/// The closed surfaces of the liver and of each structure: those of the model where it is there and up to
/// date, else those that the labels enclose. A file each, `liver`, `portal_vein`, `lesion_1`, ..., LPS
/// millimetres; nothing in them says whose they are. The folder is made if there is none. All files are
/// written before the first is put there: what fails leaves none.
/// @param ending one of surface_endings().
/// @param notes takes what was left out (surfaces_of_labels).
/// @return the files; empty: cancelled, nothing is written.
/// @throws InputError there are neither labels nor a model; another ending; surfaces in the folder that are
///   not among those to be written, as they would be taken for this patient's. FileError.
Cancellable<std::vector<std::filesystem::path>> write_case_surfaces(const std::filesystem::path& folder,
                                                                    const std::string& ending,
                                                                    const CaseState& state,
                                                                    const RunContext& context,
                                                                    std::vector<std::string>& notes);

}  // namespace glisson::engine
