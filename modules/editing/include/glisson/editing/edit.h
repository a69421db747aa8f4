// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "glisson/core/run_context.h"
#include "glisson/editing/tool.h"
#include "glisson/patient/label_map.h"
#include "glisson/volume/image.h"

/// @file
/// What a hand does to labels, as values: each tool is a struct with its settings, in a header of its own
/// under tools/, and one pure function applies it. The window, scripts and tests use the same. Points are in
/// the CT's frame; lengths are metres.
///
/// A voxel has one label, so what a tool gives to one label it takes from another. A tool that *overwrites*
/// takes whatever the region lets it. A tool that *reshapes* a label knows the anatomy: the label gains
/// background and, unless it is the parenchyma itself, parenchyma, and never another structure; what it loses
/// becomes parenchyma where that is no farther (through faces of lost voxels) than background is. For the
/// shape of the parenchyma, lesions and vessels count as part of it: they lie in it and are no holes.
/// What a tool *erases* of a vessel or a lesion that is named becomes the nearer one of parenchyma and
/// background; erasing "any label" leaves background. Each tool's header says which it does.

namespace glisson::editing {

/// Where an edit may change voxels: all of it must hold for a voxel to change (the "editable area", the
/// "editable intensity range" and "locked segments" of other programs).
struct EditableRegion {
  enum class Area {
    everywhere,
    labelled,      ///< any label
    unlabelled,    ///< background only: nothing is overwritten
    inside_label,  ///< `label` only
    inside_liver   ///< the liver with everything in it, as inside_liver() says
  };
  Area area = Area::everywhere;
  Label label = 0;  ///< for Area::inside_label
  /// Lowest and highest intensity of the CT (Hounsfield units), inclusive.
  std::optional<std::array<double, 2>> intensity;
  /// Labels that neither lose nor gain voxels.
  std::vector<Label> locked;

  /// The region is judged on the labels before the edit. For inside_liver the surroundings of the edit (20
  /// mm) are looked at and not the whole volume.
  bool operator==(const EditableRegion&) const = default;
};

/// One stroke, or one use of a tool: what, and where it may act.
struct Edit {
  Tool tool;
  EditableRegion region;

  bool operator==(const Edit&) const = default;
};

/// What a step is called in lists and on the undo button; texts are made of it in the window.
struct StepName {
  /// One of ToolKind::steps(), as "islands.keep_largest"; "segment" is no edit.
  std::string code;
  Label label = 0;    ///< that it was done to; kBackground: several
  double size = 0.0;  ///< radius, distance; metres; 0: has none
  bool operator==(const StepName&) const = default;
};
StepName step_name(const Edit& edit);

/// Whether a tool works at once where the pointer is, so that it needs no preview.
bool is_local(const Tool& tool);

/// The labels after an edit.
struct Edited {
  LabelMap labels;
  long voxels_changed = 0;
  /// "nothing_changed", and what the tool's header names.
  std::vector<std::string> notes;
};
/// The labels with one edit done. The bricks that it does not change are shared with `labels`; information of
/// labels that come into being is added, that of labels that vanish is kept. Single-threaded, deterministic;
/// empty: cancelled. Reports progress as "segmentation.edit".
/// @pre the labels and the image have one grid.
/// @throws InputError settings out of range, a label that is locked, a click outside the volume; names the
///   tool as file and its setting as field.
Cancellable<Edited> apply_edit(const LabelMap& labels, const Image& image, const Edit& edit,
                               const RunContext& context);

/// Scripts of edits: JSON {"edits": [{"tool": "paint", "label": "portal_vein", "brush": "ball", "radius_mm":
/// 3, "path_mm": [[x, y, z], ...], "region": {"area": "inside_liver", "intensity_hu": [100, 250], "locked":
/// ["lesion_1"]}}, ...]}; LPS millimetres. The manual lists the fields of each tool. @throws InputError
/// naming the entry ("edit 3, radius_mm"), also for settings that apply_edit() would refuse.
std::vector<Edit> read_edits(const std::filesystem::path& path,
                             const std::vector<const ToolKind*>& kinds = tools());
/// Atomic; reads back as written (lengths to the last bit but one).
void write_edits(const std::filesystem::path& path, const std::vector<Edit>& edits);

}  // namespace glisson::editing
