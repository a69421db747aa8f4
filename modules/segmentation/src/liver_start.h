// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/core/run_context.h"
#include "tissue.h"

namespace glisson::segmentation {

struct LiverSeeds {
  std::vector<Eigen::Vector3i> inside, outside;  ///< voxels of the field
  std::vector<Eigen::Vector3i> lesions = {};     ///< inside, too, though not in the liver's tissue
};

/// The image once more, on voxels on which a seam of fat between two organs can be seen.
struct PartingView {
  Field raw, ct;  ///< one grid; ct is denoised
};

inline constexpr double kLiverWidth = 2.2;  // standard deviations that count as liver at first

/// Tissue like the liver's that hangs on it and was left out, as another organ; see Sides.
struct Doubtful {
  double ml = 0.0;                                     ///< 0: there is none
  Eigen::Vector3d at_index = Eigen::Vector3d::Zero();  ///< of the image: where it is deepest
};

/// Who owns the liver-like tissue.
struct LiverStart {
  Mask open;     ///< what looks like liver, anywhere
  Mask own;      ///< what of it is the liver's
  Mask start;    ///< what of that is wider than a neck: where the contour starts
  Mask rival;    ///< what the clicks outside own
  Mask perhaps;  ///< the doubtful body's largest piece
  Tissue parenchyma;
  Doubtful doubtful;
};

/// Robust statistics at the clicks; what looks like that is parted at its necks and seams (see
/// part_at_necks()); once more with the statistics of what was found. A doubtful body is asked once more with
/// the dark tissue that it and the liver enclose together: a tumour is no neck. If it is the liver's then,
/// the statistics learn from it, and all is parted a last time.
/// @param barred, included known not to be liver, known to be.
/// @param likely lesions, perhaps: where they lie between two parts of the liver they are no neck.
Cancellable<LiverStart> find_start(const Field& ct, const PartingView& view, const LiverSeeds& seeds,
                                   const Mask& barred, const Mask& included, const Mask& likely,
                                   const RunContext& context);

}  // namespace glisson::segmentation
