// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "glisson/ui/segmentation/window_tool.h"

/// @file
/// From a tool with its settings, and what the mouse did, to an editing::Edit. No widgets.

namespace glisson::ui {

/// What the mouse does while the tool is chosen.
Hand hand_of(EditTool tool, const EditSettings& settings);
/// Whether it works on the whole volume, and so is previewed, applied or cancelled.
bool is_previewed(EditTool tool, const EditSettings& settings);
/// The brush one notch larger or smaller.
double brush_after(double radius, double notches);

/// One stretch of a stroke: of a disc an edit for each layer of voxels that the slice shows along it, several
/// only where the volume's layers are askew to the slice. None: it lies outside the volume. They are one
/// gesture. @param invert paints instead of erasing, and the other way.
/// @param path CT frame, metres. @pre the tool is a brush, the path is finite
std::vector<editing::Edit> brush_edits(EditTool tool, const EditSettings& settings, const VolumeGrid& grid,
                                       const scene::SliceGeometry& slice, const Points& path, bool invert);
/// A lasso in a slice, its corners in pixels of the slice. @param invert fills what would be erased.
editing::Edit slice_cut(const EditSettings& settings, const VolumeGrid& grid,
                        const scene::SliceGeometry& slice,
                        const Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>& outline,
                        bool invert);
/// A lasso over the 3D view: as deep as the volume.
editing::Edit volume_cut(const EditSettings& settings, const VolumeLasso& lasso, bool invert);
/// A click of level tracing, islands or move branch. @param clicked label at the place. Empty: nothing can be
/// done there (a branch is moved only of a portal or hepatic tree).
std::optional<editing::Edit> click_edit(EditTool tool, const EditSettings& settings, const VolumeGrid& grid,
                                        scene::Plane plane, const Point<CtFrame>& p, Label clicked,
                                        bool invert);
/// A tool that is_previewed(). @param present labels that have voxels.
editing::Edit whole_edit(EditTool tool, const EditSettings& settings, const VolumeGrid& grid,
                         const std::vector<Label>& present);

/// Why a tool cannot be used now.
EditObstacle obstacle_of(EditTool tool, const EditSettings& settings, const std::vector<Label>& present);

}  // namespace glisson::ui
