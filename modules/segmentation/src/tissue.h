// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "field.h"

namespace glisson::segmentation {

/// Normal distribution of a tissue's intensity, estimated robustly.
struct Tissue {
  double mean = 0.0, sigma = 1.0;
};

inline constexpr double kLeastLiverSigma = 3.0, kMostLiverSigma = 15.0;  // HU, after denoising
inline constexpr float kEmptyTissue = -30.0F;                            // HU: fat, lung and gas are darker
/// HU that a liver differs from one end to the other (perfusion, hardened beams).
inline constexpr double kDrift = 8.0;
inline constexpr double kVesselWidth = 5.0;  // mm, closed over in the liver-like tissue

/// @throws InputError an empty image, or no CT.
void require_ct(const Image& image);

/// Median and scaled median absolute deviation within `radius_mm` of the points. sigma is kept in
/// [low_sigma, high_sigma].
Tissue tissue_around(const Field& ct, const std::vector<Eigen::Vector3i>& points, double radius_mm,
                     double low_sigma, double high_sigma);

/// The same over a mask's voxels. @pre any is set.
Tissue tissue_in(const Field& ct, const Mask& mask);

/// What the clicks say of the liver: the middle of what they show, and how much that varies within a click
/// and between them. A click on a tumour is one of several.
Tissue liver_at(const Field& ct, const std::vector<Eigen::Vector3i>& clicks);

/// The tissue over the depth of a region, what it encloses included: unlike the window that made the region,
/// this does not cut the tails off. sigma 0: the region is nowhere as deep.
Tissue tissue_within(const Field& ct, const Mask& region, double depth_mm);

}  // namespace glisson::segmentation
