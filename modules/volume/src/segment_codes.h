// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>

/// @file
/// How a segment's meaning stands in files. Used by the library and by the reading program.

namespace glisson {

struct Code {
  std::string scheme, value, meaning;
};
struct SegmentCodes {
  Code category{"SCT", "85756007", "Tissue"}, type{"SCT", "85756007", "Tissue"}, region;
};

/// Slicer's terminology entry: context~category~type~modifier~context~region~modifier, codes as
/// SCHEME^VALUE^MEANING. What is missing in it stays as it is by default.
SegmentCodes codes_of_terminology(const std::string& entry);
std::string terminology_of(const SegmentCodes& codes);

/// What SegmentDescription says in files of Glisson, before the label's code and its review's state.
inline constexpr const char* kOwnSegment = "Glisson label ";

/// sRGB in [0, 1] as DICOM's CIELab of 16 bits a value (PS3.3 C.10.7.1.1), and back.
std::array<unsigned short, 3> dicom_lab(const std::array<double, 3>& rgb);
std::array<double, 3> rgb_of_dicom_lab(const std::array<unsigned short, 3>& lab);

}  // namespace glisson
