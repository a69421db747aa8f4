// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "raw_volume.h"

namespace glisson::reader {

/// The files that a DICOMDIR names (DICOM PS3.3, F.3: Referenced File ID), from its folder, with "/" between
/// folders; each once, in its order. What would lead out of the folder is left out.
/// @throws InputError it is no DICOM directory, or damaged.
std::vector<std::string> files_of_dicomdir(const Request& request);

}  // namespace glisson::reader
