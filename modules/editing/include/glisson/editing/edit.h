// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "glisson/core/run_context.h"
#include "glisson/editing/tool.h"
#include "glisson/geometry/mesh.h"
#include "glisson/patient/label_map.h"
#include "glisson/volume/image.h"
#include "glisson/volume/morphology.h"

/// @file
/// What a hand does to labels, as values: each tool is a struct with its settings (its description stands in
/// its own source, see tool.h), and one pure function applies it. The window, scripts and tests use the same.
/// Points are in the CT's frame; lengths are metres.
///
/// A voxel has one label, so what a tool gives to one label it takes from another. Paint, Threshold,
/// Scissors, LevelTracing and Logical overwrite whatever the region lets them. The tools that reshape a label
/// (FillHoles, Smooth but joint, Margin, InterpolateSlices) know the anatomy: the label gains background and,
/// unless it is the parenchyma itself, parenchyma, and never another structure; what it loses becomes
/// parenchyma where that is no farther (through faces of lost voxels) than background is. For the shape of
/// the parenchyma, lesions and vessels count as part of it: they lie in it and are no holes.
/// What Paint, Scissors, LevelTracing and Islands take from a vessel or a lesion that is named becomes the
/// nearer one of parenchyma and background; erasing "any label" leaves background.

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

/// A brush drawn along a path: a ball, or a disc in the slice of the path. All voxels whose centres lie
/// within the radius of the path, and those that the path runs through, however small the brush. The path may
/// leave the volume.
struct Paint {
  static const ToolKind& kind();
  enum class Brush { disc, ball };
  Label label = structure::kParenchyma;
  /// Takes voxels of `label` away; with kBackground of any label. What a vessel or a lesion loses becomes
  /// what is nearer of parenchyma and background (within 12 mm of the stroke; parenchyma where they are
  /// equally near), so that a branch that is rubbed out leaves no hole in the liver. Otherwise background.
  bool erase = false;
  Brush brush = Brush::disc;
  double radius = 5e-3;
  int normal_axis = 2;     ///< disc: the voxel axis across the slice, 0, 1 or 2
  PointsIn<CtFrame> path;  ///< one point or more, CT frame

  bool operator==(const Paint&) const;  // paths of different lengths differ
};

/// Everything between two intensities becomes `label`.
struct Threshold {
  static const ToolKind& kind();
  Label label = structure::kParenchyma;
  double low = 100.0, high = 300.0;  ///< Hounsfield units, inclusive
  bool replace = false;              ///< what `label` had before is lost

  bool operator==(const Threshold&) const = default;
};

/// A closed line drawn over a view, in a slice or in three dimensions: what lies behind it, or beside it.
/// Inside is what the line winds about, so that overlapping ends cut no hole; what is behind the viewer is
/// outside.
struct Scissors {
  static const ToolKind& kind();
  enum class Operation { fill_inside, erase_inside, erase_outside };
  Label label = structure::kParenchyma;  ///< erasing with kBackground takes any label
  Operation operation = Operation::erase_inside;
  /// Homogeneous CT point (metres) to homogeneous view place. Affine for a slice. Points behind the viewer
  /// have a third component <= 0.
  Eigen::Matrix<double, 3, 4> view_from_ct = Eigen::Matrix<double, 3, 4>::Zero();
  Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor> outline;  ///< in the view, closed by itself
  /// Only voxels with |normal . p - offset| <= half_thickness are cut; empty: as deep as the volume.
  struct Slab {
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< unit
    double offset = 0.0;
    double half_thickness = 0.0;
    bool operator==(const Slab&) const = default;
  };
  std::optional<Slab> slab;

  bool operator==(const Scissors&) const;
};

/// Labels compete from the voxels that they have for the unlabelled voxels about them: along paths of little
/// difference in intensity (a shortest-path form of GrowCut; Zhu 2014). A step costs the square of the
/// difference of two neighbours in the image after a median of three along each axis, and 5 HU^2 for each mm.
struct GrowFromSeeds {
  static const ToolKind& kind();
  /// One or more that may grow, and with the rivals two or more; kBackground cannot be one.
  std::vector<Label> labels;
  double reach = 20e-3;  ///< no farther from a seed than this
  /// Labels that only compete: what they win is given back ("not this").
  std::vector<Label> rivals;

  bool operator==(const GrowFromSeeds&) const = default;
};

/// The region of like intensity around a click in one slice, without holes, bounded by the iso-line through
/// the click in the slice smoothed by a binomial of five. Of the two sides of the line the one that does not
/// reach the slice's edge, else the smaller one (note "level_tracing.open").
struct LevelTracing {
  static const ToolKind& kind();
  Label label = structure::kParenchyma;
  bool erase = false;
  int normal_axis = 2;
  Eigen::Vector3d p_in_ct = Eigen::Vector3d::Zero();

  bool operator==(const LevelTracing&) const = default;
};

/// Parts of a label that do not share a face.
struct Islands {
  static const ToolKind& kind();
  enum class Operation {
    keep_largest,
    remove_small,  ///< below `smallest_ml`
    keep_clicked,
    remove_clicked,
    /// Each but the largest becomes a label of its own, by falling size: the next free lesion for a lesion,
    /// else the next free "other" label. When none is free the rest stay (note "islands_left:3").
    split
  };
  Label label = structure::kParenchyma;
  Operation operation = Operation::keep_largest;
  double smallest_ml = 1.0;
  Eigen::Vector3d p_in_ct = Eigen::Vector3d::Zero();

  bool operator==(const Islands&) const = default;
};

/// Background (see above) that the label encloses.
struct FillHoles {
  static const ToolKind& kind();
  Label label = structure::kParenchyma;
  bool in_slices = false;  ///< holes of one slice count, too (in any of the three axes)

  bool operator==(const FillHoles&) const = default;
};

struct Smooth {
  static const ToolKind& kind();
  enum class Method {
    median,   ///< majority in a ball (of its voxels inside the volume)
    closing,  ///< fills what a ball of the radius cannot enter
    opening,  ///< takes what a ball cannot fill
    joint     ///< all labels at once, without gaps between them: each voxel to the commonest in a ball
  };
  Label label = structure::kParenchyma;  ///< not for joint
  Method method = Method::median;
  double radius = 3e-3;

  bool operator==(const Smooth&) const = default;
};

/// Grows (positive) or shrinks (negative) by a distance between voxel centres.
struct Margin {
  static const ToolKind& kind();
  Label label = structure::kParenchyma;
  double distance = 3e-3;

  bool operator==(const Margin&) const = default;
};

/// Fills the slices between those where something is drawn (Raya and Udupa 1990: mean of signed distances).
struct InterpolateSlices {
  static const ToolKind& kind();
  Label label = structure::kParenchyma;
  int normal_axis = 2;

  bool operator==(const InterpolateSlices&) const = default;
};

/// Set algebra on labels. As no voxel has two, add and copy take the voxels from the other label, subtracting
/// another label changes nothing and intersecting with another leaves nothing; inverting and filling
/// overwrite whatever the region lets them.
struct Logical {
  static const ToolKind& kind();
  enum class Operation { copy, add, subtract, intersect, invert, clear, fill };
  Label label = structure::kParenchyma;
  Operation operation = Operation::add;
  Label other = structure::kBackground;  ///< for copy, add, subtract, intersect

  bool operator==(const Logical&) const = default;
};

/// What hangs on a tree beyond the thinnest place near a click, seen from the tree's root, goes to another
/// label.
struct ReassignBranch {
  static const ToolKind& kind();
  Label label = structure::kPortalVein;  ///< that loses it
  /// kBackground: is cut off, and becomes parenchyma or background as what a reshaped label loses.
  Label to = structure::kHepaticVeins;
  Eigen::Vector3d p_in_ct = Eigen::Vector3d::Zero();

  bool operator==(const ReassignBranch&) const = default;
};

struct Edit {
  Tool tool;
  EditableRegion region;

  bool operator==(const Edit&) const = default;
};

/// What a step is called in lists and on the undo button; texts are made of it in the window.
struct StepName {
  /// One of ToolKind::steps(): "paint", "erase", "islands.keep_largest"; "segment" is no edit.
  std::string code;
  Label label = 0;    ///< that it was done to; kBackground: several
  double size = 0.0;  ///< radius, distance; metres; 0: has none
  bool operator==(const StepName&) const = default;
};
StepName step_name(const Edit& edit);

/// Whether a tool works at once where the pointer is (paint, level tracing, scissors in a slice, reassign),
/// so that it needs no preview.
bool is_local(const Tool& tool);

struct Edited {
  LabelMap labels;
  long voxels_changed = 0;
  /// "nothing_changed", "no_slices_between", "islands_left:N", "level_tracing.open".
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
