// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/engine/case_state.h"
#include "glisson/volume/dicom_source.h"

namespace glisson::engine {

namespace part {
/// Whose image it is, and its DICOM series. Absent where the image's files do not say it.
extern const PartOf<DicomSource> source;
}  // namespace part

}  // namespace glisson::engine
