// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "field.h"
#include "glisson/core/run_context.h"
#include "tissue.h"

namespace glisson::segmentation {

/// mm before the liver that a click on a trunk is followed from.
constexpr double kFarthestClick = 60.0;
/// mm from a click to the vessel that it means: clicks are not exact.
constexpr double kBesideVessel = 5.0;

struct VesselSeeds {
  std::vector<Eigen::Vector3i> portal, hepatic;  ///< voxels of the field
  bool from_cava = true;  ///< where hepatic veins were clicked, others grow from the cava's wall
};

struct Vessels {
  Mask portal, hepatic;
  /// Its clicks are hardly brighter than the parenchyma, so that it is not told from the noise: another
  /// phase. Where nothing tells it from the parenchyma, the tree is empty.
  bool portal_is_faint = false, hepatic_is_faint = false;
};

/// Tubeness of bright vessels over several scales, in HU: the largest over sigma of sigma^2 times the smaller
/// of the two strongest downward curvatures (after Sato 1998), 0 where a curvature points up. Only where
/// `where` is set.
Cancellable<std::vector<float>> tubeness(const Field& ct, const Mask& where,
                                         const std::vector<double>& sigmas_mm, const RunContext& context);

/// Both venous trees. Candidates are bright or tubular; what the seeds reach through them is parted between
/// the trees by split_trees().
/// @param ct lightly smoothed, about 1 mm. @param liver filled. @param cava a source of the hepatic veins
/// (see VesselSeeds::from_cava); they end there. @param barred structures that no vessel runs through.
Cancellable<Vessels> find_vessels(const Field& ct, const Mask& liver, const Mask& cava, const Mask& barred,
                                  const Tissue& parenchyma, const VesselSeeds& seeds,
                                  const RunContext& context);

}  // namespace glisson::segmentation
