// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "glisson/engine/landmark_origin.h"
#include "glisson/experiments/demo.h"

namespace glisson::experiments {

/// report.html of a demo. @param pictures names of the files under pictures/, without ending.
/// @param landmarks the case's table of decisions
void write_demo_report(const std::filesystem::path& path, const std::string& patient,
                       const std::vector<std::string>& pictures,
                       const std::vector<engine::LandmarkOrigin>& landmarks, const DemoResult& result);

}  // namespace glisson::experiments
