// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "glisson/core/run_context.h"
#include "glisson/geometry/mesh.h"
#include "glisson/patient/label_map.h"
#include "glisson/volume/image.h"
#include "glisson/volume/morphology.h"

/// @file
/// What a hand does to labels, as values: each tool is a struct with its settings, and one pure function
/// applies it. The window, scripts and tests use the same. Points are in the CT's frame; lengths are metres.

namespace glisson::segmentation {

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

  bool operator==(const EditableRegion&) const = default;
};

/// A brush drawn along a path: a ball, or a disc in the slice of the path.
struct Paint {
  enum class Brush { disc, ball };
  Label label = structure::kParenchyma;
  bool erase = false;  ///< takes voxels of `label` away; with kBackground of any label
  Brush brush = Brush::disc;
  double radius = 5e-3;
  int normal_axis = 2;  ///< disc: the voxel axis across the slice, 0, 1 or 2
  Points path;          ///< one point or more, CT frame

  bool operator==(const Paint&) const;  // paths of different lengths differ
};

/// Everything between two intensities becomes `label`.
struct Threshold {
  Label label = structure::kParenchyma;
  double low = 100.0, high = 300.0;  ///< Hounsfield units, inclusive
  bool replace = false;              ///< what `label` had before is lost

  bool operator==(const Threshold&) const = default;
};

/// A closed line drawn over a view, in a slice or in three dimensions: what lies behind it, or beside it.
struct Scissors {
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
/// difference in intensity (a shortest-path form of GrowCut; Zhu 2014).
struct GrowFromSeeds {
  std::vector<Label> labels;  ///< two or more; kBackground cannot be one
  double reach = 20e-3;       ///< no farther from a seed than this
  /// Labels that only compete: what they win is given back ("not this").
  std::vector<Label> rivals;

  bool operator==(const GrowFromSeeds&) const = default;
};

/// The region of like intensity around a click in one slice, bounded by the iso-line through it.
struct LevelTracing {
  Label label = structure::kParenchyma;
  bool erase = false;
  int normal_axis = 2;
  Eigen::Vector3d p_in_ct = Eigen::Vector3d::Zero();

  bool operator==(const LevelTracing&) const = default;
};

struct Islands {
  enum class Operation {
    keep_largest,
    remove_small,  ///< below `smallest_ml`
    keep_clicked,
    remove_clicked,
    split  ///< each but the largest becomes a label of its own: the next free lesion or "other" label
  };
  Label label = structure::kParenchyma;
  Operation operation = Operation::keep_largest;
  double smallest_ml = 1.0;
  Eigen::Vector3d p_in_ct = Eigen::Vector3d::Zero();

  bool operator==(const Islands&) const = default;
};

struct FillHoles {
  Label label = structure::kParenchyma;
  bool in_slices = false;  ///< holes of one slice count, too (in any of the three axes)

  bool operator==(const FillHoles&) const = default;
};

struct Smooth {
  enum class Method {
    median,   ///< majority in a ball
    closing,  ///< fills what a ball of the radius cannot enter
    opening,  ///< takes what a ball cannot fill
    joint     ///< all labels at once, without gaps between them
  };
  Label label = structure::kParenchyma;  ///< not for joint
  Method method = Method::median;
  double radius = 3e-3;

  bool operator==(const Smooth&) const = default;
};

/// Grows (positive) or shrinks (negative) by a distance.
struct Margin {
  Label label = structure::kParenchyma;
  double distance = 3e-3;

  bool operator==(const Margin&) const = default;
};

/// Fills the slices between those where something is drawn (Raya and Udupa 1990: mean of signed distances).
struct InterpolateSlices {
  Label label = structure::kParenchyma;
  int normal_axis = 2;

  bool operator==(const InterpolateSlices&) const = default;
};

struct Logical {
  enum class Operation { copy, add, subtract, intersect, invert, clear, fill };
  Label label = structure::kParenchyma;
  Operation operation = Operation::add;
  Label other = structure::kBackground;  ///< for copy, add, subtract, intersect

  bool operator==(const Logical&) const = default;
};

/// What hangs on a tree beyond the thinnest place near a click, seen from the tree's root, goes to another
/// label.
struct ReassignBranch {
  Label label = structure::kPortalVein;  ///< that loses it
  Label to = structure::kHepaticVeins;   ///< kBackground: is cut off
  Eigen::Vector3d p_in_ct = Eigen::Vector3d::Zero();

  bool operator==(const ReassignBranch&) const = default;
};

using Tool = std::variant<Paint, Threshold, Scissors, GrowFromSeeds, LevelTracing, Islands, FillHoles, Smooth,
                          Margin, InterpolateSlices, Logical, ReassignBranch>;

struct Edit {
  Tool tool;
  EditableRegion region;

  bool operator==(const Edit&) const = default;
};

/// What a step is called in lists and on the undo button; texts are made of it in the window.
struct StepName {
  std::string code;   ///< of the tool: "paint", "erase", "threshold", "islands.keep_largest", ..., "segment"
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
  std::vector<std::string> notes;  ///< codes with values: "nothing_changed", "no_slices_between", ...
};
/// The labels with one edit done. The bricks that it does not change are shared with `labels`; information of
/// labels that come into being is added. Single-threaded, deterministic; empty: cancelled.
/// @pre the labels and the image have one grid.
/// @throws InputError settings out of range, a label that is locked, a click outside the volume; names the
///   tool as file and its setting as field.
Cancellable<Edited> apply_edit(const LabelMap& labels, const Image& image, const Edit& edit,
                               const RunContext& context);

/// Scripts of edits: JSON {"edits": [{"tool": "paint", "label": "portal_vein", "radius_mm": 3, "path_mm":
/// [[x, y, z], ...], "region": {...}}, ...]}; LPS millimetres. @throws InputError naming the entry and its
/// field.
std::vector<Edit> read_edits(const std::filesystem::path& path);
/// Atomic; reads back as written.
void write_edits(const std::filesystem::path& path, const std::vector<Edit>& edits);

}  // namespace glisson::segmentation
