// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "glisson/editing/edit.h"
#include "glisson/ui/common/hand.h"
#include "glisson/volume/grid.h"

/// @file
/// From a tool with its settings, and what the mouse did, to a editing::Edit. No widgets.

namespace glisson::ui {

enum class EditTool {
  none,
  paint,
  erase,
  scissors,
  threshold,
  grow,
  level_tracing,
  islands,
  fill_holes,
  smooth,
  margin,
  interpolate,
  logical,
  move_branch
};
inline constexpr std::array<EditTool, 13> kEditTools = {
    EditTool::paint,         EditTool::erase,   EditTool::scissors,   EditTool::threshold, EditTool::grow,
    EditTool::level_tracing, EditTool::islands, EditTool::fill_holes, EditTool::smooth,    EditTool::margin,
    EditTool::interpolate,   EditTool::logical, EditTool::move_branch};
/// "paint", "level_tracing", ...: for names of widgets and icons.
std::string tool_code(EditTool tool);
/// The key that chooses it: 'P' for paint.
char tool_key(EditTool tool);

/// How deep a lasso in a slice cuts.
enum class CutDepth { slice, slab, through };

/// Settings of all tools; each keeps its own while another is used.
struct EditSettings {
  Label label = structure::kParenchyma;  ///< that tools work on
  editing::EditableRegion region;        ///< `locked` included

  double brush_radius = 5e-3;  ///< metres
  bool ball = false;
  bool erase_any = false;  ///< not only `label`

  double low = 100.0, high = 300.0;  ///< threshold, Hounsfield units
  bool replace = false;

  editing::Scissors::Operation cut = editing::Scissors::Operation::erase_inside;
  CutDepth depth = CutDepth::slice;
  double slab = 10e-3;   ///< metres, whole thickness
  bool cut_any = false;  ///< erase any label

  double reach = 20e-3;              ///< grow, metres
  std::vector<Label> not_growing{};  ///< labels that stay as they are

  editing::Islands::Operation islands = editing::Islands::Operation::keep_largest;
  double smallest_ml = 1.0;

  bool holes_in_slices = false;

  editing::Smooth::Method smooth = editing::Smooth::Method::median;
  double smooth_radius = 3e-3;

  bool shrink = false;
  double margin = 3e-3;  ///< metres, positive

  scene::Plane between = scene::Plane::axial;  ///< interpolate between slices of this plane

  editing::Logical::Operation logical = editing::Logical::Operation::add;
  Label other = structure::kPortalVein;

  bool cut_branch_off = false;  ///< else a branch goes to the other tree

  bool operator==(const EditSettings&) const = default;
};
inline constexpr double kSmallestBrush = 0.5e-3, kLargestBrush = 50e-3;  ///< metres

/// Whether the tool's islands are chosen by a click.
bool islands_by_click(const EditSettings& settings);
/// What the mouse does while the tool is chosen.
Hand hand_of(EditTool tool, const EditSettings& settings);
/// Whether it works on the whole volume, and so is previewed, applied or cancelled.
bool is_previewed(EditTool tool, const EditSettings& settings);
/// The brush one notch larger or smaller.
double brush_after(double radius, double notches);

/// The voxel axis across slices of a plane.
int voxel_axis_across(const VolumeGrid& grid, scene::Plane plane);

/// One stretch of a stroke: of a disc an edit for each layer of voxels that the slice shows along it, several
/// only where the volume's layers are askew to the slice. None: it lies outside the volume. They are one
/// gesture. @param tool paint or erase; `invert` makes one of the other. @pre the path is finite
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
enum class EditObstacle { none, no_volume, label_locked, label_empty, other_empty, same_label, one_label };
EditObstacle obstacle_of(EditTool tool, const EditSettings& settings, const std::vector<Label>& present);

}  // namespace glisson::ui
