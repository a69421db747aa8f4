// SPDX-License-Identifier: GPL-3.0-or-later
#include "bright_lesions.h"

#include <cmath>

#include "glisson/core/statistics.h"
#include "glisson/volume/voxel_neighbours.h"

namespace glisson::segmentation {
namespace {

/// Of the surface: the two ends of a cylinder that is twice as long as it is wide. A vein goes on at both
/// ends of a piece of it, and passes a lesion.
constexpr double kEnds = 0.2;
constexpr double kBrighter = 1.5;  // sigmas of the liver, as where a click tells tissue of its own

/// What a lesion is among veins.
struct AmongVeins {
  double surface_mm2 = 0.0;
  double on_veins_mm2 = 0.0;  ///< the surface behind which a vein goes on
  std::vector<float> hu;      ///< of its voxels
};

std::vector<AmongVeins> among_veins(const Image& image, const Painting& painting, std::size_t lesions) {
  std::vector<AmongVeins> result(lesions);
  const VolumeGrid& grid = painting.grid;
  for (std::size_t at = 0; at < painting.labels.size(); ++at) {
    const Label own = painting.labels[at];
    const auto n = static_cast<std::size_t>(own - structure::kFirstLesion);
    if (!is_lesion(own) || n >= lesions) continue;
    AmongVeins& lesion = result[n];
    lesion.hu.push_back((*image.voxels)[at]);
    each_face_neighbour(grid.size, at, [&](std::size_t beside, int axis) {
      const Label other = painting.labels[beside];
      const double area = grid.voxel_volume_mm3() / grid.spacing_mm[axis];
      if (other != own) lesion.surface_mm2 += area;
      if (other == structure::kPortalVein || other == structure::kHepaticVeins) lesion.on_veins_mm2 += area;
    });
  }
  return result;
}

}  // namespace

std::vector<std::string> bright_lesion_notes(const Image& image, const Painting& painting,
                                             std::size_t lesions, const Tissue& parenchyma) {
  std::vector<std::string> notes;
  std::vector<AmongVeins> all = among_veins(image, painting, lesions);
  for (std::size_t n = 0; n < all.size(); ++n) {
    AmongVeins& lesion = all[n];
    if (lesion.hu.empty()) continue;
    const double above = upper_median(std::move(lesion.hu)) - parenchyma.mean;
    const std::string name = "lesion_" + std::to_string(n + 1);
    if (above > 0.0 && lesion.on_veins_mm2 >= kEnds * lesion.surface_mm2)
      notes.push_back(name + ".perhaps_vein " +
                      std::to_string(std::lround(100.0 * lesion.on_veins_mm2 / lesion.surface_mm2)));
    else if (above > kBrighter * parenchyma.sigma)
      notes.push_back(name + ".bright");
  }
  return notes;
}

}  // namespace glisson::segmentation
