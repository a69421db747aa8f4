// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/editing/edit.h"

#include <cmath>

#include "edit_tools.h"
#include "glisson/core/error.h"

namespace glisson::editing {
namespace {

/// std::visit over one function object per kind of tool.
template <class... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

template <class Matrix>
bool same_matrix(const Matrix& a, const Matrix& b) {
  return a.rows() == b.rows() && a.cols() == b.cols() && (a.array() == b.array()).all();
}

std::string operation_name(Scissors::Operation operation) {
  switch (operation) {
    case Scissors::Operation::fill_inside:
      return "fill_inside";
    case Scissors::Operation::erase_inside:
      return "erase_inside";
    case Scissors::Operation::erase_outside:
      break;
  }
  return "erase_outside";
}

std::string operation_name(Islands::Operation operation) {
  static constexpr std::array<const char*, 5> kNames = {"keep_largest", "remove_small", "keep_clicked",
                                                        "remove_clicked", "split"};
  return kNames[static_cast<std::size_t>(operation)];
}

std::string operation_name(Smooth::Method method) {
  static constexpr std::array<const char*, 4> kNames = {"median", "closing", "opening", "joint"};
  return kNames[static_cast<std::size_t>(method)];
}

std::string operation_name(Logical::Operation operation) {
  static constexpr std::array<const char*, 7> kNames = {"copy",   "add",   "subtract", "intersect",
                                                        "invert", "clear", "fill"};
  return kNames[static_cast<std::size_t>(operation)];
}

/// The one label that seeds grow for; background when they are several.
Label grown_label(const GrowFromSeeds& tool) {
  Label only = structure::kBackground;
  for (const Label label : tool.labels) {
    if (std::find(tool.rivals.begin(), tool.rivals.end(), label) != tool.rivals.end()) continue;
    if (only != structure::kBackground && only != label) return structure::kBackground;
    only = label;
  }
  return only;
}

}  // namespace

bool Paint::operator==(const Paint& other) const {
  return label == other.label && erase == other.erase && brush == other.brush && radius == other.radius &&
         normal_axis == other.normal_axis && same_matrix(path, other.path);
}

bool Scissors::operator==(const Scissors& other) const {
  return label == other.label && operation == other.operation &&
         same_matrix(view_from_ct, other.view_from_ct) && same_matrix(outline, other.outline) &&
         slab == other.slab;
}

StepName step_name(const Edit& edit) {
  return std::visit(
      Overloaded{[](const Paint& t) {
                   return StepName{t.erase ? "erase" : "paint", t.label, t.radius};
                 },
                 [](const Threshold& t) {
                   return StepName{"threshold", t.label, 0.0};
                 },
                 [](const Scissors& t) {
                   return StepName{"scissors." + operation_name(t.operation), t.label, 0.0};
                 },
                 [](const GrowFromSeeds& t) {
                   return StepName{"grow_from_seeds", grown_label(t), t.reach};
                 },
                 [](const LevelTracing& t) {
                   return StepName{t.erase ? "level_tracing.erase" : "level_tracing", t.label, 0.0};
                 },
                 [](const Islands& t) {
                   return StepName{"islands." + operation_name(t.operation), t.label, 0.0};
                 },
                 [](const FillHoles& t) {
                   return StepName{"fill_holes", t.label, 0.0};
                 },
                 [](const Smooth& t) {
                   const Label label = t.method == Smooth::Method::joint ? structure::kBackground : t.label;
                   return StepName{"smooth." + operation_name(t.method), label, t.radius};
                 },
                 [](const Margin& t) {
                   return StepName{t.distance < 0.0 ? "margin.shrink" : "margin.grow", t.label,
                                   std::abs(t.distance)};
                 },
                 [](const InterpolateSlices& t) {
                   return StepName{"interpolate_slices", t.label, 0.0};
                 },
                 [](const Logical& t) {
                   return StepName{"logical." + operation_name(t.operation), t.label, 0.0};
                 },
                 [](const ReassignBranch& t) {
                   return StepName{t.to == structure::kBackground ? "reassign_branch.cut" : "reassign_branch",
                                   t.label, 0.0};
                 }},
      edit.tool);
}

bool is_local(const Tool& tool) {
  const auto* scissors = std::get_if<Scissors>(&tool);
  return std::holds_alternative<Paint>(tool) || std::holds_alternative<LevelTracing>(tool) ||
         std::holds_alternative<ReassignBranch>(tool) || (scissors != nullptr && scissors->slab.has_value());
}

Cancellable<Edited> apply_edit(const LabelMap& labels, const Image& image, const Edit& edit,
                               const RunContext& context) {
  require(labels.voxels.grid().same_as(image.grid) && (image.empty() == labels.voxels.empty()),
          "the labels that are edited and the image have one grid");
  check_edit(edit);
  if (context.cancelled()) return std::nullopt;
  context.progress(0.0, "segmentation.edit");
  Task task{labels, image, edit.region, context};
  const Cancellable<Canvas> canvas =
      std::visit([&](const auto& tool) { return apply_tool(tool, task); }, edit.tool);
  if (!canvas || context.cancelled()) return std::nullopt;
  Edited edited{canvas->finish(), canvas->changed(), std::move(task.notes)};
  if (edited.voxels_changed == 0) edited.notes.emplace_back("nothing_changed");
  context.progress(1.0, "segmentation.edit");
  return edited;
}

}  // namespace glisson::editing
