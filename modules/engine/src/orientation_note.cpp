// SPDX-License-Identifier: GPL-3.0-or-later
#include "orientation_note.h"

#include <algorithm>
#include <cmath>

#include "glisson/atlas/orientation.h"
#include "glisson/engine/commands/propose_landmarks.h"
#include "glisson/model/label_surfaces.h"

namespace glisson::engine {
namespace {

constexpr double kEnoughMm = 3.0;  // the shape is judged by pieces of 14 mm

/// Liver and vessels on voxels of about kEnoughMm, of which each is one of the finer ones.
LabelMap thinned(const LabelVolume& labels) {
  VolumeGrid grid = labels.grid();
  const Eigen::Vector3i step = (kEnoughMm / grid.spacing_mm.array()).floor().cast<int>().max(1);
  grid.size = (grid.size.array() - 1) / step.array() + 1;
  grid.spacing_mm.array() *= step.cast<double>().array();
  LabelMap map{LabelVolume(grid), {structure_info(structure::kParenchyma)}};
  for (int k = 0; k < grid.size.z(); ++k)
    for (int j = 0; j < grid.size.y(); ++j)
      for (int i = 0; i < grid.size.x(); ++i) {
        const Eigen::Vector3i voxel(i, j, k);
        const Label label = labels.at(voxel.cwiseProduct(step));
        if (is_liver_tissue(label)) map.voxels.set(voxel, structure::kParenchyma);
        if (label == structure::kPortalVein || label == structure::kHepaticVeins ||
            label == structure::kArtery)
          map.voxels.set(voxel, label);
      }
  return map;
}

}  // namespace

bool note_orientation(const atlas::Atlas* known, model::BuiltModel& built, const RunContext& context) {
  if (known == nullptr) return true;
  auto doubts = atlas::orientation_doubts(*known, fine_liver(built.model), context);
  if (!doubts) return false;
  for (std::string& doubt : *doubts) built.report.notes.push_back(std::move(doubt));
  return true;
}

Cancellable<std::vector<std::string>> orientation_notes(const atlas::Atlas* known, const LabelMap& labels,
                                                        const RunContext& context) {
  if (known == nullptr) return std::vector<std::string>();
  const LabelMap few = thinned(labels.voxels);
  if (std::ranges::count(inside_liver(few), 1) == 0) return std::vector<std::string>();
  std::vector<std::string> dropped;
  const auto surfaces = model::surfaces_of_labels(few, context.part(0.0, 0.5), dropped);
  if (!surfaces) return {};
  for (const NamedSurface& surface : *surfaces)
    if (surface.structure == structure::kParenchyma)
      return atlas::orientation_doubts(*known, surface.mesh, context.part(0.5, 1.0));
  return std::vector<std::string>();
}

}  // namespace glisson::engine
