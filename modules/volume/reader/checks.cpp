// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "glisson/core/confinement.h"
#include "glisson/core/error.h"
#include "glisson/core/patient_range.h"
#include "most_values.h"
#include "raw_volume.h"

namespace glisson::reader {
namespace {

constexpr double kSmallestSpacing = 0.02,
                 kLargestSpacing = 50.0;   // mm: microscopes and metres are neither CT
constexpr double kLargestExtent = 4000.0;  // mm

std::string text(const Eigen::Vector3d& v) {
  std::ostringstream stream;
  stream << v.x() << " x " << v.y() << " x " << v.z();
  return stream.str();
}

}  // namespace

void refuse(const Request& request, const std::string& field, const std::string& problem,
            const std::string& remedy) {
  throw InputError(request.name, field, problem, remedy);
}

void raise_limits(double file_bytes, double values) {
  const double machine =
      static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
  limit_memory(std::min(machine, 1e9 + 16.0 * (file_bytes + values)));
  limit_seconds(20.0 + 1e-6 * file_bytes + 5e-7 * values);
}

void check_value_count(const Request& request, const Eigen::Vector3i& size, int components) {
  const double values = static_cast<double>(size.x()) * size.y() * size.z() * components;
  if ((size.array() < 1).any() || components < 1 || values > kMostVolumeValues)
    throw InputError(
        request.name, "size",
        "claims " + text(size.cast<double>()) + " voxels of " + std::to_string(components) + " value(s)",
        "The header is damaged, or crop the volume");
}

VolumeGrid checked_grid(const Request& request, const Eigen::Vector3i& size,
                        const Eigen::Vector3d& spacing_mm, const Eigen::Vector3d& origin_mm,
                        const Eigen::Matrix3d& direction) {
  check_value_count(request, size, 1);
  if (!spacing_mm.allFinite() || (spacing_mm.array() < kSmallestSpacing).any() ||
      (spacing_mm.array() > kLargestSpacing).any() ||
      (spacing_mm.cwiseProduct(size.cast<double>()).array() > kLargestExtent).any())
    throw InputError(request.name, "spacing", "is " + text(spacing_mm) + " mm, which is no patient's",
                     "Check that the file's unit is the millimetre and correct its header");
  if (!origin_mm.allFinite() || (origin_mm.array().abs() > 1e3 * kPatientRange).any())
    throw InputError(request.name, "origin",
                     "is (" + text(origin_mm) + ") mm, which is nowhere near a scanner",
                     "Correct the file's header");
  if (!direction.allFinite() ||
      !(direction.transpose() * direction).isApprox(Eigen::Matrix3d::Identity(), 2e-3))
    throw InputError(request.name, "direction", "has axes that are not at right angles (a sheared volume)",
                     "Resample the volume to a rectangular grid");
  VolumeGrid grid;
  grid.size = size;
  grid.spacing_mm = spacing_mm;
  grid.origin_mm = origin_mm;
  grid.direction = direction;
  return grid;
}

}  // namespace glisson::reader
