// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/editing/tools/scissors.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "describe.h"
#include "edit_shape.h"

namespace glisson::editing {
namespace {

/// A closed line in a view; says whether a place is inside: it is wound about (so the overlapping ends of a
/// line drawn by hand cut no hole). Edges are sorted into bands of v, so that a question looks at few.
class Outline {
 public:
  explicit Outline(const Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>& points)
      : low_(points.colwise().minCoeff().transpose()), high_(points.colwise().maxCoeff().transpose()) {
    bands_.resize(static_cast<std::size_t>(std::clamp<Eigen::Index>(2 * points.rows(), 16, 1024)));
    scale_ = static_cast<double>(bands_.size()) / std::max(high_.y() - low_.y(), 1e-300);
    for (Eigen::Index n = 0; n < points.rows(); ++n) {
      const Eigen::Vector2d a = points.row(n).transpose();
      const Eigen::Vector2d b = points.row((n + 1) % points.rows()).transpose();
      if (a.y() == b.y()) continue;
      for (std::size_t band = band_of(std::min(a.y(), b.y())); band <= band_of(std::max(a.y(), b.y()));
           ++band)
        bands_[band].push_back({a, b});
    }
  }

  bool contains(const Eigen::Vector2d& p) const {
    if (!((p.array() >= low_.array()).all() && (p.array() <= high_.array()).all())) return false;
    int winding = 0;
    for (const Edge& e : bands_[band_of(p.y())]) {
      const bool up = e.a.y() <= p.y() && e.b.y() > p.y(), down = e.b.y() <= p.y() && e.a.y() > p.y();
      if (!up && !down) continue;
      const double side = (e.b.x() - e.a.x()) * (p.y() - e.a.y()) - (p.x() - e.a.x()) * (e.b.y() - e.a.y());
      if (up && side > 0.0) ++winding;
      if (down && side < 0.0) --winding;
    }
    return winding != 0;
  }
  /// Whether a rectangle of the view lies wholly beside the outline.
  bool misses(const Eigen::Vector2d& low, const Eigen::Vector2d& high) const {
    return (low.array() > high_.array()).any() || (high.array() < low_.array()).any();
  }

 private:
  struct Edge {
    Eigen::Vector2d a, b;
  };
  std::size_t band_of(double v) const {
    const double band = std::floor((v - low_.y()) * scale_);
    return static_cast<std::size_t>(std::clamp(band, 0.0, static_cast<double>(bands_.size() - 1)));
  }
  Eigen::Vector2d low_, high_;
  double scale_ = 1.0;
  std::vector<std::vector<Edge>> bands_;
};

/// The cut in voxel indices.
struct Cut {
  Eigen::Matrix<double, 3, 4> view_from_index;
  Eigen::Vector4d slab = Eigen::Vector4d::Zero();  ///< distance from its middle, metres: slab . (index, 1)
  double half_thickness = std::numeric_limits<double>::infinity();
};

Cut cut_of(const Scissors& tool, const VolumeGrid& grid) {
  Eigen::Matrix4d ct_from_index = Eigen::Matrix4d::Identity();
  ct_from_index.topLeftCorner<3, 3>() = 1e-3 * grid.direction * grid.spacing_mm.asDiagonal();
  ct_from_index.topRightCorner<3, 1>() = 1e-3 * grid.origin_mm;
  Cut cut;
  cut.view_from_index = tool.view_from_ct * ct_from_index;
  if (tool.slab) {
    const Eigen::Vector4d plane(tool.slab->normal.x(), tool.slab->normal.y(), tool.slab->normal.z(),
                                -tool.slab->offset);
    cut.slab = ct_from_index.transpose() * plane;
    // A voxel on the slab's face is in it, whatever the rounding.
    cut.half_thickness = tool.slab->half_thickness + 1e-9;
  }
  return cut;
}

/// Whether the slab misses a part of a brick: decided at the corners.
bool beside_slab(const Cut& cut, const VoxelBox& part) {
  if (!std::isfinite(cut.half_thickness)) return false;
  const Eigen::Vector3d half = 0.5 * (part.size() - Eigen::Vector3i::Ones()).cast<double>();
  const Eigen::Vector3d middle = part.low.cast<double>() + half;
  const double reach = cut.slab.head<3>().cwiseAbs().dot(half);
  return std::abs(cut.slab.dot(middle.homogeneous())) > reach + cut.half_thickness;
}

/// Whether every voxel of a part of a brick is seen beside the outline's rectangle.
bool beside_outline(const Cut& cut, const Outline& outline, const VoxelBox& part) {
  Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d index((corner & 1) != 0 ? part.high.x() - 1 : part.low.x(),
                                (corner & 2) != 0 ? part.high.y() - 1 : part.low.y(),
                                (corner & 4) != 0 ? part.high.z() - 1 : part.low.z());
    const Eigen::Vector3d seen = cut.view_from_index * index.homogeneous();
    // With a corner behind the viewer the others say nothing about what lies between.
    if (seen.z() <= 0.0) return false;
    low = low.cwiseMin(seen.hnormalized());
    high = high.cwiseMax(seen.hnormalized());
  }
  return outline.misses(low, high);
}

Cancellable<Canvas> apply(const Scissors& tool, Task& task) {
  using Operation = Scissors::Operation;
  const VoxelBox box = whole_box(task.grid());
  Canvas canvas = task.canvas(box);
  const Cut cut = cut_of(tool, task.grid());
  const Outline outline(tool.outline);
  const bool fill = tool.operation == Operation::fill_inside;
  const bool outside = tool.operation == Operation::erase_outside;
  // What a vessel or a lesion loses is known when all of it is.
  const bool gathers = !fill && lies_in_liver(tool.label);
  std::vector<Eigen::Vector3i> lost;
  const auto propose = [&](int i, int j, int k, Label old) -> Label {
    if (fill ? old == tool.label
             : old == structure::kBackground || (tool.label != structure::kBackground && old != tool.label))
      return old;
    const Eigen::Vector4d index(i, j, k, 1.0);
    if (std::abs(cut.slab.dot(index)) > cut.half_thickness) return old;
    const Eigen::Vector3d seen = cut.view_from_index * index;
    const bool inside = seen.z() > 0.0 && outline.contains(seen.hnormalized());
    if (inside == outside) return old;
    if (gathers) lost.emplace_back(i, j, k);
    return fill ? tool.label : gathers ? old : structure::kBackground;
  };
  const double slices = std::max(1, box.high.z());
  const bool done = for_each_brick_in(task.labels.voxels, box, [&](std::size_t number, const VoxelBox& part) {
    if (task.context.cancelled()) return false;
    if (part.low.x() == 0) task.context.progress(0.8 * part.low.z() / slices, "segmentation.edit");
    if (!fill && !task.labels.voxels.brick(number)) return true;
    if (beside_slab(cut, part) || (!outside && beside_outline(cut, outline, part))) return true;
    canvas.rewrite_part(number, part, propose);
    return true;
  });
  if (!done || !take_away(canvas, lost, tool.label, task.context.part(0.8, 1.0))) return std::nullopt;
  return canvas;
}

using Operation = Scissors::Operation;

const Names<Operation>& operations() {
  static const Names<Operation> kNames = {{"fill_inside", Operation::fill_inside},
                                          {"erase_inside", Operation::erase_inside},
                                          {"erase_outside", Operation::erase_outside}};
  return kNames;
}

void check_line(const SettingsCheck& check, const Scissors& t) {
  if (t.outline.rows() < 3) check.refuse("outline", "has fewer than three points", "Draw around an area");
  if (!t.outline.allFinite())
    check.refuse("outline", "has a place that is not finite", "Draw it in the view");
  if (!t.view_from_ct.allFinite() ||
      Eigen::JacobiSVD<Eigen::MatrixXd>(t.view_from_ct).setThreshold(1e-12).rank() < 3)
    check.refuse("view_from_ct", "shows no view of space", "Give the 3 x 4 matrix of the view");
}

void check_slab(const SettingsCheck& check, const Scissors& t) {
  if (!t.slab) return;
  if (!t.slab->normal.allFinite() || std::abs(t.slab->normal.norm() - 1.0) > 1e-6)
    check.refuse("slab", "has a normal that is not of length 1", "Normalise it");
  if (!std::isfinite(t.slab->offset)) check.refuse("slab", "has an offset that is not finite", "Give metres");
  if (!(t.slab->half_thickness > 0.0))
    check.refuse("slab", "is " + millimetres(2.0 * t.slab->half_thickness) + " thick",
                 "Choose at least a slice's thickness");
}

Fields<Scissors::Slab> slab_fields() {
  using Slab = Scissors::Slab;
  Field<Slab> normal{field_of("normal", ToolField::Kind::point),
                     [](ScriptEntry& e, Slab& s) { s.normal = Eigen::Vector3d(e.row("normal", 3).data()); },
                     [](nlohmann::json& json, const Slab& s) {
                       json["normal"] = {s.normal.x(), s.normal.y(), s.normal.z()};
                     }};
  return {std::move(normal), length_field("offset_mm", &Slab::offset),
          length_field("half_thickness_mm", &Slab::half_thickness)};
}

Field<Scissors> slab_field() {
  constexpr const char* kCode = "slab";
  const Fields<Scissors::Slab> parts = slab_fields();
  ToolField field = field_of(kCode, ToolField::Kind::object);
  field.has_default = true;
  field.parts = about(parts);
  return {field,
          [=](ScriptEntry& e, Scissors& t) {
            if (!e.has(kCode)) return;
            ScriptEntry slab = e.object(kCode);
            t.slab = Scissors::Slab();
            read_fields(parts, slab, *t.slab);
            slab.finish();
          },
          [=](nlohmann::json& json, const Scissors& t) {
            if (t.slab) json[kCode] = written(parts, *t.slab);
          },
          check_slab};
}

Description<Scissors> description() {
  return {"scissors",
          30,
          {label_field<Scissors>("label", &Scissors::label,
                                 [](const Scissors& t) { return t.operation != Operation::fill_inside; }),
           choice_field("operation", &Scissors::operation, operations()),
           matrix_field("view_from_ct", &Scissors::view_from_ct).noted("3 x 4, of metres"),
           matrix_field("outline", &Scissors::outline).noted("[u, v] in the view").checked(check_line),
           slab_field()},
          steps_of("scissors", operations()),
          [](const Scissors& t) {
            return StepName{"scissors." + name_of(operations(), t.operation), t.label, 0.0};
          },
          apply,
          [](const Scissors& t) { return t.slab.has_value(); }};
}

}  // namespace

bool Scissors::operator==(const Scissors& other) const {
  return label == other.label && operation == other.operation &&
         same_matrix(view_from_ct, other.view_from_ct) && same_matrix(outline, other.outline) &&
         slab == other.slab;
}

const ToolKind& Scissors::kind() {
  static const Described<Scissors> kKind(description());
  return kKind;
}
const ToolKind& scissors_tool() { return Scissors::kind(); }

}  // namespace glisson::editing
