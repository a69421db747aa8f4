// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "glisson/volume/series.h"

namespace glisson::ui {

/// Words for what the DICOM series of a folder are, for window and command line.
QString doubt_text(SeriesDoubt doubt);
/// All that speaks against a series, parted by semicolons; empty: nothing.
QString doubts_text(const DicomSeries& series);
/// Empty where nothing is said.
QString phase_text(SeriesPhase phase);
/// Pixel by pixel by slice in millimetres, and the slices' thickness where it is another than their distance;
/// empty: unknown.
QString spacing_text(const DicomSeries& series);
/// The description, or that there is none.
QString description_text(const DicomSeries& series);

}  // namespace glisson::ui
