// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "glisson/patient/label_map.h"
#include "glisson/segmentation/segment.h"
#include "glisson/volume/morphology.h"

/// @file
/// A box of an image, and what belongs to it.

namespace glisson::segmentation {

/// Whether the voxel nearest to a place (CT frame, metres) is one of the image's.
bool holds(const VolumeGrid& image, const Eigen::Vector3d& p_in_ct);

/// The voxels of a box in the patient (CT frame, metres), none where it lies beside the image; all of them
/// without one.
VoxelBox box_of(const VolumeGrid& grid, const std::optional<Eigen::AlignedBox3d>& region);
/// The image around points, in voxels, kept inside.
VoxelBox box_around(const VolumeGrid& image, const Points& points, double reach_mm);

/// Whether a voxel's centre lies in the region: of a volume that is askew in the patient, the region's box of
/// voxels holds others, too.
bool is_in(const std::optional<Eigen::AlignedBox3d>& region, const VolumeGrid& grid,
           const Eigen::Vector3i& voxel);

/// The voxel of the part at a place in metres. Empty: outside of the part or of the region.
std::optional<Eigen::Vector3i> voxel_in(const VolumeGrid& part,
                                        const std::optional<Eigen::AlignedBox3d>& region,
                                        const Eigen::Vector3d& p_in_ct);

bool is_among(const std::vector<Label>& labels, Label label);
/// Parenchyma and what lies within: vessels, arteries, lesions.
bool is_in_liver(Label label);
/// Adds the structure's name to the labels' where it is not there.
void name_structure(Label structure, LabelMap& labels);

Image part_of(const Image& image, const VoxelBox& box);
LabelMap part_of(const LabelMap& labels, const VoxelBox& box);
/// The seeds that lie in the part; lesions keep their numbers.
/// @param part the part's own grid.
Seeds part_of(const Seeds& seeds, const VolumeGrid& part, const std::optional<Eigen::AlignedBox3d>& region);

}  // namespace glisson::segmentation
