// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glisson/engine/landmark_origin.h"
#include "report.h"

namespace glisson::experiments {

/// The table of decisions for a report: per structure its source, the atlas' deviation, and what a person
/// made of it.
ReportTable landmark_table(const std::vector<engine::LandmarkOrigin>& landmarks);

}  // namespace glisson::experiments
