// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "glisson/engine/case_state.h"

namespace glisson::engine {

/// Writes the case's labels with names, meaning and review; the format by extension: .dcm is a DICOM
/// segmentation that refers to the CT's series, without the patient's name, ID and birth date.
/// @pre the state has labels. @throws InputError, FileError as write_labels.
void write_case_labels(const std::filesystem::path& path, const CaseState& state);

}  // namespace glisson::engine
