// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/segmentation/evaluate.h"

#include "connections.h"
#include "glisson/core/error.h"
#include "glisson/segmentation/segment.h"

namespace glisson::segmentation {
namespace {

using Voxels = std::vector<std::uint8_t>;

double volume_ml(const Voxels& mask, double voxel_mm3) {
  long count = 0;
  for (const std::uint8_t voxel : mask) count += voxel != 0;
  return 1e-3 * voxel_mm3 * static_cast<double>(count);
}

Voxels both(Voxels a, const Voxels& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] = a[i] != 0 && b[i] != 0;
  return a;
}

}  // namespace

Agreement agreement(const Voxels& mask, const Voxels& truth, double voxel_mm3) {
  require(mask.size() == truth.size(), "masks that are compared have one size");
  return {dice(mask, truth), volume_ml(mask, voxel_mm3), volume_ml(truth, voxel_mm3)};
}

Figures compare_labels(const LabelMap& labels, const LabelMap& truth) {
  require(labels.voxels.grid().same_as(truth.voxels.grid()), "labels that are compared have one grid");
  const double voxel_mm3 = truth.voxels.grid().voxel_volume_mm3();
  Figures figures;
  const auto add = [&](const std::string& name, const Voxels& mask, const Voxels& of_truth) {
    const Agreement agreed = agreement(mask, of_truth, voxel_mm3);
    figures["dice_" + name] = agreed.dice;
    figures[name + "_ml"] = agreed.ml;
    figures[name + "_truth_ml"] = agreed.truth_ml;
  };
  const Voxels true_liver = inside_liver(truth);
  add("liver", inside_liver(labels), true_liver);
  const std::vector<long> present = truth.voxels.histogram();
  const auto is_present = [&](Label label) { return label < present.size() && present[label] > 0; };
  for (Label label = structure::kPortalVein; label < structure::kFirstOther; ++label) {
    if (!is_present(label)) continue;
    const auto is_it = [label](Label other) { return other == label; };
    const Voxels mask = labels.voxels.mask(is_it), of_truth = truth.voxels.mask(is_it);
    add(structure_name(label), mask, of_truth);
    if (label == structure::kPortalVein || label == structure::kHepaticVeins) {
      add(structure_name(label) + "_inside", both(mask, true_liver), both(of_truth, true_liver));
      const Connections reached = count_connections(truth, labels, label, true_liver),
                        claimed = count_connections(labels, truth, label, true_liver);
      figures["tips_" + structure_name(label) + "_truth"] = reached.ways;
      figures["tips_" + structure_name(label) + "_truth_found"] = reached.found;
      figures["tips_" + structure_name(label)] = claimed.ways;
      figures["tips_" + structure_name(label) + "_true"] = claimed.found;
    }
  }
  const Voxels true_lesions = truth.voxels.mask(is_lesion);
  if (volume_ml(true_lesions, voxel_mm3) > 0.0) add("lesions", labels.voxels.mask(is_lesion), true_lesions);
  return figures;
}

}  // namespace glisson::segmentation
