// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/SVD>
#include <cmath>
#include <sstream>

#include "edit_tools.h"
#include "glisson/core/error.h"

namespace glisson::editing {
namespace {

constexpr double kLargestBrush = 0.1, kLargestReach = 0.2, kLargestSmooth = 0.02,
                 kLargestMargin = 0.05;   // metres: beyond it a slip of the unit is likelier than a wish
constexpr double kFarthestPoint = 100.0;  // metres

std::string millimetres(double metres) {
  std::ostringstream stream;
  stream << 1e3 * metres << " mm";
  return stream.str();
}

/// The checks that tools share, with the tool's name for messages.
class Check {
 public:
  Check(std::string tool, const EditableRegion& region) : tool_(std::move(tool)), region_(region) {}

  [[noreturn]] void refuse(const std::string& field, const std::string& problem,
                           const std::string& remedy) const {
    throw InputError(tool_, field, problem, remedy);
  }
  /// A label that the tool gives to voxels, or takes from them.
  void target(Label label, const char* field = "label", bool background = false) const {
    if (label == structure::kBackground && !background)
      refuse(field, "is the background", "Choose a structure");
    if (label > structure::kLastLesion)
      refuse(field, "is " + std::to_string(label) + ", which is no structure",
             "Choose 1 to " + std::to_string(structure::kLastLesion));
    if (label != structure::kBackground &&
        std::find(region_.locked.begin(), region_.locked.end(), label) != region_.locked.end())
      refuse(field, "is " + structure_name(label) + ", which is locked", "Unlock it, or choose another one");
  }
  void length(double metres, const char* field, double most) const {
    if (!(metres > 0.0 && metres <= most))
      refuse(field, "is " + millimetres(metres), "Choose more than 0 and at most " + millimetres(most));
  }
  void axis(int number) const {
    if (number < 0 || number > 2)
      refuse("normal_axis", "is " + std::to_string(number),
             "Choose 0, 1 or 2: the voxel axis across the slice");
  }
  void point(const Eigen::Vector3d& p, const char* field) const {
    if (!p.allFinite() || p.cwiseAbs().maxCoeff() > kFarthestPoint)
      refuse(field, "has a point that is nowhere near a patient", "Give points of the CT's frame");
  }

  void operator()(const Paint& t) const {
    target(t.label, "label", t.erase);
    length(t.radius, "radius", kLargestBrush);
    axis(t.normal_axis);
    if (t.path.rows() == 0) refuse("path", "has no point", "Give at least one");
    for (Eigen::Index n = 0; n < t.path.rows(); ++n) point(t.path.row(n).transpose(), "path");
  }
  void operator()(const Threshold& t) const {
    target(t.label);
    if (!(t.low <= t.high) || !std::isfinite(t.low) || !std::isfinite(t.high))
      refuse("low", "is " + std::to_string(t.low) + " with a high of " + std::to_string(t.high),
             "Choose a low that is not above the high");
  }
  void operator()(const Scissors& t) const {
    target(t.label, "label", t.operation != Scissors::Operation::fill_inside);
    if (t.outline.rows() < 3) refuse("outline", "has fewer than three points", "Draw around an area");
    if (!t.outline.allFinite()) refuse("outline", "has a place that is not finite", "Draw it in the view");
    if (!t.view_from_ct.allFinite() ||
        Eigen::JacobiSVD<Eigen::MatrixXd>(t.view_from_ct).setThreshold(1e-12).rank() < 3)
      refuse("view_from_ct", "shows no view of space", "Give the 3 x 4 matrix of the view");
    if (!t.slab) return;
    if (!t.slab->normal.allFinite() || std::abs(t.slab->normal.norm() - 1.0) > 1e-6)
      refuse("slab", "has a normal that is not of length 1", "Normalise it");
    if (!std::isfinite(t.slab->offset)) refuse("slab", "has an offset that is not finite", "Give metres");
    if (!(t.slab->half_thickness > 0.0))
      refuse("slab", "is " + millimetres(2.0 * t.slab->half_thickness) + " thick",
             "Choose at least a slice's thickness");
  }
  void operator()(const GrowFromSeeds& t) const {
    LabelSet all;
    int different = 0, growing = 0;
    const auto count = [&](Label label, bool rival) {
      if (all.contains(label)) return;
      all.insert(label);
      ++different;
      growing += rival ? 0 : 1;
    };
    for (const Label label : t.rivals) {
      if (label == structure::kBackground || label > structure::kLastLesion)
        refuse("rivals", "name " + structure_name(label), "Choose structures that have voxels");
      count(label, true);
    }
    for (const Label label : t.labels) {
      target(label, "labels");
      count(label, false);
    }
    if (growing == 0) refuse("labels", "are none that may keep what they win", "Choose one or more to grow");
    if (different < 2) refuse("labels", "are fewer than two with the rivals", "Choose labels that compete");
    length(t.reach, "reach", kLargestReach);
  }
  void operator()(const LevelTracing& t) const {
    target(t.label, "label", t.erase);
    axis(t.normal_axis);
    point(t.p_in_ct, "p_in_ct");
  }
  void operator()(const Islands& t) const {
    target(t.label);
    if (t.operation == Islands::Operation::remove_small && !(t.smallest_ml > 0.0 && t.smallest_ml <= 1e4))
      refuse("smallest_ml", "is " + std::to_string(t.smallest_ml), "Choose more than 0 and at most 10000 ml");
    point(t.p_in_ct, "p_in_ct");
  }
  void operator()(const FillHoles& t) const { target(t.label); }
  void operator()(const Smooth& t) const {
    if (t.method != Smooth::Method::joint) target(t.label);
    length(t.radius, "radius", kLargestSmooth);
  }
  void operator()(const Margin& t) const {
    target(t.label);
    length(std::abs(t.distance), "distance", kLargestMargin);
  }
  void operator()(const InterpolateSlices& t) const {
    target(t.label);
    axis(t.normal_axis);
  }
  void operator()(const Logical& t) const {
    target(t.label);
    using Operation = Logical::Operation;
    const bool moves = t.operation == Operation::copy || t.operation == Operation::add;
    if (moves)
      target(t.other, "other", true);  // it loses voxels
    else if (t.other > structure::kLastLesion)
      refuse("other", "is " + std::to_string(t.other) + ", which is no structure", "Choose a structure");
  }
  void operator()(const ReassignBranch& t) const {
    target(t.label);
    target(t.to, "to", true);
    if (t.to == t.label) refuse("to", "is the label that the branch has", "Choose another one");
    point(t.p_in_ct, "p_in_ct");
  }

  void region() const {
    if (region_.intensity) {
      const auto [low, high] = *region_.intensity;
      if (!(low <= high) || !std::isfinite(low) || !std::isfinite(high))
        refuse("region.intensity", "runs from " + std::to_string(low) + " to " + std::to_string(high),
               "Choose a low that is not above the high");
    }
    if (region_.area == EditableRegion::Area::inside_label && region_.label > structure::kLastLesion)
      refuse("region.label", "is " + std::to_string(region_.label) + ", which is no structure",
             "Choose a structure");
  }

 private:
  std::string tool_;
  const EditableRegion& region_;
};

}  // namespace

std::string tool_name(const Tool& tool) {
  static constexpr std::array<const char*, 12> kNames = {
      "paint",      "threshold", "scissors", "grow_from_seeds",    "level_tracing", "islands",
      "fill_holes", "smooth",    "margin",   "interpolate_slices", "logical",       "reassign_branch"};
  static_assert(std::variant_size_v<Tool> == kNames.size());
  return kNames[tool.index()];
}

void check_edit(const Edit& edit) {
  const Check check(tool_name(edit.tool), edit.region);
  check.region();
  std::visit(check, edit.tool);
}

Eigen::Vector3i voxel_at(const VolumeGrid& grid, const Eigen::Vector3d& p_in_ct, const char* tool) {
  const Eigen::Vector3d index = grid.index_of(Point<CtFrame>(p_in_ct)).array().round();
  if ((index.array() < 0.0).any() || (index.array() >= grid.size.array().cast<double>()).any())
    throw InputError(tool, "p_in_ct", "lies outside the volume", "Click inside the picture");
  return index.cast<int>();
}

}  // namespace glisson::editing
