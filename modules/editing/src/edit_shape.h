// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "edit_canvas.h"

namespace glisson::editing {

/// What counts as inside when a tool looks at the shape of a label: the label itself; for the parenchyma also
/// the lesions and vessels, as they lie in it and are no holes of it.
LabelSet shape_of(Label label);

/// Whether a tool that reshapes `label` may take a voxel of `from`: background, and, unless it is the
/// parenchyma itself, parenchyma. Other structures are never overwritten by such a tool.
bool may_gain(Label label, Label from);

/// Vessels and lesions: what they lose leaves no hole in the liver. What lies elsewhere leaves nothing.
bool lies_in_liver(Label label);

/// For the voxels in `lost` (they have `label` and shall not keep it): parenchyma, where it is no farther
/// through faces of lost voxels than background is, else background. Voxels that are not lost are left 0.
/// @param before the labels in the box of `lost`, i fastest.
std::vector<Label> given_away(const Mask& lost, const std::vector<Label>& before, Label label);

/// Says what a voxel becomes that was erased from a vessel or a lesion: the nearer one of parenchyma and
/// background, looked for within 12 mm of a box; parenchyma where they are equally near.
class Surroundings {
 public:
  Surroundings(const LabelVolume& labels, const VoxelBox& work);
  Label at(int i, int j, int k) const;

 private:
  VoxelBox box_;
  std::vector<float> to_tissue_, to_background_;
};

/// Takes voxels from `label`: of a vessel or a lesion they become what Surroundings says, else background.
/// @returns false when cancelled.
bool take_away(Canvas& canvas, const std::vector<Eigen::Vector3i>& lost, Label label,
               const RunContext& context);

/// Gives `label` a new shape in a box: it gains what it may, and loses what is no longer inside.
/// @param after the new shape; has the size of the box, which reaches a voxel beyond all that is lost.
/// @returns false when cancelled.
bool reshape(Canvas& canvas, const VoxelBox& box, const Mask& after, Label label, const RunContext& context);

}  // namespace glisson::editing
