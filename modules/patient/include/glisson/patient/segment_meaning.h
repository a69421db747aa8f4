// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glisson/patient/label_map.h"

/// @file
/// What segments mean in SNOMED CT (as PS3.16 codes them), and which structures those are.

namespace glisson {

/// Slicer's terminology entry of a structure: "liver" for the parenchyma, "lesion" in the region of the liver
/// for lesions; "tissue" for what has no meaning of its own.
std::string structure_terminology(Label label);

/// Whether a segment has no name: "label_7" is what Glisson writes where there is none.
bool is_nameless(const LabelInfo& segment);
/// Whether it has one, and not the one that Glisson gives to the same number.
bool is_named_otherwise(const LabelInfo& segment);

/// Which structure each segment is, by its name where that is Glisson's, else by the coded meaning in
/// LabelInfo::terminology; lesions are numbered in the segments' order. Segments that mean something else are
/// left out, and lesions whose region is said and is not the liver.
LabelCodes codes_meant(const std::vector<LabelInfo>& segments);

}  // namespace glisson
