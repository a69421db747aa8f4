// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "glisson/core/run_context.h"
#include "glisson/geometry/mesh.h"
#include "glisson/patient/label_map.h"
#include "glisson/volume/image.h"

namespace glisson::segmentation {

/// What a person clicks. CT frame, metres. File: JSON {"liver": [[x, y, z] mm LPS, ...], "portal_vein": ...,
/// ...}.
struct Seeds {
  Points liver;
  Points portal_vein, hepatic_veins, vena_cava, gallbladder;
  std::vector<Points> lesions;
  Points background;  ///< "not liver": optional
};
Seeds read_seeds(const std::filesystem::path& path);
void write_seeds(const std::filesystem::path& path, const Seeds& seeds);

struct SegmentationOptions {
  double working_spacing_mm = 2.0;  ///< resolution of the level set
  void validate() const;
};

struct SegmentationReport {
  double liver_ml = 0.0, portal_ml = 0.0, hepatic_ml = 0.0;
  std::vector<double> lesion_ml;
  std::vector<std::string> notes;
};
struct Segmented {
  LabelMap labels;
  SegmentationReport report;
};

/// Liver by a geodesic active contour from seeds (speed from intensity statistics and gradient), smoothing,
/// hole filling, largest component; vessels by vesselness and growth from their seeds, portal and hepatic
/// kept apart; lesions each its own label. @throws InputError seeds outside the image, none for the liver,
/// not a CT.
Cancellable<Segmented> segment(const Image& image, const Seeds& seeds, const SegmentationOptions& options,
                               const RunContext& context);

/// Dice coefficient of two masks of one grid.
double dice(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b);

}  // namespace glisson::segmentation
