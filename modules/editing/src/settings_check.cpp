// SPDX-License-Identifier: GPL-3.0-or-later
#include "settings_check.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "glisson/core/error.h"
#include "glisson/core/patient_range.h"

namespace glisson::editing {

std::string millimetres(double metres) {
  std::ostringstream stream;
  stream << 1e3 * metres << " mm";
  return stream.str();
}

void SettingsCheck::refuse(const std::string& setting, const std::string& problem,
                           const std::string& remedy) const {
  throw InputError(tool_, setting, problem, remedy);
}

void SettingsCheck::target(Label label, const std::string& setting, bool background) const {
  if (label == structure::kBackground && !background)
    refuse(setting, "is the background", "Choose a structure");
  if (label > structure::kLastLesion)
    refuse(setting, "is " + std::to_string(label) + ", which is no structure",
           "Choose 1 to " + std::to_string(structure::kLastLesion));
  if (label != structure::kBackground &&
      std::find(region_.locked.begin(), region_.locked.end(), label) != region_.locked.end())
    refuse(setting, "is " + structure_name(label) + ", which is locked", "Unlock it, or choose another one");
}

void SettingsCheck::length(double metres, const std::string& setting, double most) const {
  if (!(metres > 0.0 && metres <= most))
    refuse(setting, "is " + millimetres(metres), "Choose more than 0 and at most " + millimetres(most));
}

void SettingsCheck::axis(int number, const std::string& setting) const {
  if (number < 0 || number > 2)
    refuse(setting, "is " + std::to_string(number), "Choose 0, 1 or 2: the voxel axis across the slice");
}

void SettingsCheck::point(const Eigen::Vector3d& p, const std::string& setting) const {
  if (!p.allFinite() || p.cwiseAbs().maxCoeff() > kPatientRange)
    refuse(setting, "has a point that is nowhere near a patient", "Give points of the CT's frame");
}

void SettingsCheck::region() const {
  if (region_.intensity) {
    const auto [low, high] = *region_.intensity;
    if (!(low <= high) || !std::isfinite(low) || !std::isfinite(high))
      refuse("region.intensity", "runs from " + std::to_string(low) + " to " + std::to_string(high),
             "Choose a low that is not above the high");
  }
  if (region_.area == EditableRegion::Area::inside_label && region_.label > structure::kLastLesion)
    refuse("region.label", "is " + std::to_string(region_.label) + ", which is no structure",
           "Choose a structure");
}

}  // namespace glisson::editing
