// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/editing/tools/paint.h"

#include <cmath>

#include "describe.h"
#include "edit_shape.h"
#include "glisson/core/error.h"

namespace glisson::editing {
namespace {

constexpr double kLargest = 0.1;  ///< metres: beyond it a slip of the unit is likelier than a wish

/// A segment of a stroke, in millimetres along the voxel axes (index times spacing): rotations and flips of
/// the volume in the patient play no part there, as its axes are at right angles.
struct Segment {
  Eigen::Vector3d a, b;
  double radius2 = 0.0;

  bool contains(const Eigen::Vector3d& p) const {
    const Eigen::Vector3d along = b - a;
    const double length2 = along.squaredNorm();
    const double t = length2 > 0.0 ? std::clamp((p - a).dot(along) / length2, 0.0, 1.0) : 0.0;
    return (p - a - t * along).squaredNorm() <= radius2;
  }
};

/// First and last place on the line p + x e_x within a ball about `centre`; false when it is missed.
bool meets_ball(const Eigen::Vector3d& p, const Eigen::Vector3d& centre, double radius2, double& low,
                double& high) {
  const double across2 = (p - centre).tail<2>().squaredNorm();
  if (across2 > radius2) return false;
  const double half = std::sqrt(radius2 - across2);
  low = std::min(low, centre.x() - half);
  high = std::max(high, centre.x() + half);
  return true;
}

/// Where the line p + x e_x (p.x = 0) runs inside the segment's cylinder, without its caps.
void meet_cylinder(const Eigen::Vector3d& p, const Segment& segment, double& low, double& high) {
  const Eigen::Vector3d along = segment.b - segment.a;
  const double length2 = along.squaredNorm();
  if (length2 <= 0.0) return;
  const Eigen::Vector3d axis = along / std::sqrt(length2), w = p - segment.a;
  // |(w + x e) - axis (axis . (w + x e))|^2 <= r^2, and 0 <= axis . (w + x e) <= length.
  const Eigen::Vector3d e = Eigen::Vector3d::UnitX() - axis * axis.x();
  const Eigen::Vector3d w_across = w - axis * axis.dot(w);
  const double qa = e.squaredNorm(), qb = e.dot(w_across), qc = w_across.squaredNorm() - segment.radius2;
  double from = -1e9, to = 1e9;
  if (qa > 1e-12) {
    const double root = qb * qb - qa * qc;
    if (root < 0.0) return;
    from = (-qb - std::sqrt(root)) / qa;
    to = (-qb + std::sqrt(root)) / qa;
  } else if (qc > 0.0) {
    return;
  }
  if (std::abs(axis.x()) > 1e-12) {
    double start = -axis.dot(w) / axis.x(), end = (std::sqrt(length2) - axis.dot(w)) / axis.x();
    if (start > end) std::swap(start, end);
    from = std::max(from, start);
    to = std::min(to, end);
  } else if (axis.dot(w) < 0.0 || axis.dot(w) > std::sqrt(length2)) {
    return;
  }
  if (from > to) return;
  low = std::min(low, from);
  high = std::max(high, to);
}

/// Calls run(j, k, i0, i1) for the rows of voxels in `box` whose centres lie within the radius of the
/// segment. A capsule is convex: in each row they are one run.
template <class Run>
void for_each_run(const Segment& segment, const VolumeGrid& grid, const VoxelBox& box, Run&& run) {
  const double h = grid.spacing_mm.x();
  for (int k = box.low.z(); k < box.high.z(); ++k)
    for (int j = box.low.y(); j < box.high.y(); ++j) {
      const Eigen::Vector3d p(0.0, j * grid.spacing_mm.y(), k * grid.spacing_mm.z());
      double low = 1e9, high = -1e9;
      meets_ball(p, segment.a, segment.radius2, low, high);
      meets_ball(p, segment.b, segment.radius2, low, high);
      meet_cylinder(p, segment, low, high);
      if (low > high) continue;
      // The ends by the same test as every other voxel, whatever the square roots were rounded to.
      const auto inside = [&](int i) { return segment.contains({i * h, p.y(), p.z()}); };
      int first = std::max(box.low.x(), static_cast<int>(std::floor(low / h)) - 1);
      int last = std::min(box.high.x() - 1, static_cast<int>(std::ceil(high / h)) + 1);
      while (first <= last && !inside(first)) ++first;
      while (last >= first && !inside(last)) --last;
      run(j, k, first, last + 1);
    }
}

/// A stroke's points as fractional voxel indices.
std::vector<Eigen::Vector3d> indices_of(const VolumeGrid& grid, const Points& path) {
  const Eigen::Matrix3d to_index = grid.spacing_mm.cwiseInverse().asDiagonal() * grid.direction.inverse();
  std::vector<Eigen::Vector3d> indices;
  for (Eigen::Index n = 0; n < path.rows(); ++n)
    indices.push_back(to_index * (1e3 * path.row(n).transpose() - grid.origin_mm));
  return indices;
}

/// The slice of a disc's path. @throws InputError when it runs through several.
int slice_of(const std::vector<Eigen::Vector3d>& indices, int axis) {
  const double slice = std::round(indices.front()[axis]);
  for (const Eigen::Vector3d& index : indices)
    if (std::abs(index[axis] - slice) > 0.75)
      throw InputError("paint", "path", "runs through several slices",
                       "Draw a disc in one slice, or use a ball");
  return static_cast<int>(std::clamp(slice, -1e6, 1e6));
}

/// The voxels that can lie within `radius_mm` of a segment.
VoxelBox box_around(const Segment& segment, const VolumeGrid& grid, double radius_mm) {
  const Eigen::Array3d h = grid.spacing_mm.array();
  const Eigen::Array3d low = ((segment.a.cwiseMin(segment.b).array() - radius_mm) / h).floor();
  const Eigen::Array3d high = ((segment.a.cwiseMax(segment.b).array() + radius_mm) / h).ceil() + 1.0;
  return intersection(
      {low.max(-1e6).min(1e6).matrix().cast<int>(), high.max(-1e6).min(1e6).matrix().cast<int>()},
      whole_box(grid));
}

/// The voxels that a segment runs through, for brushes finer than a voxel.
template <class Visit>
void for_each_voxel_on(const Eigen::Vector3d& from, const Eigen::Vector3d& to, Visit&& visit) {
  const int steps = std::max(1, static_cast<int>(std::ceil(2.0 * (to - from).cwiseAbs().maxCoeff())));
  for (int n = 0; n <= steps; ++n)
    visit((from + (to - from) * (static_cast<double>(n) / steps)).array().round().matrix().cast<int>());
}

Cancellable<Canvas> apply(const Paint& tool, Task& task) {
  const VolumeGrid& grid = task.grid();
  std::vector<Eigen::Vector3d> indices = indices_of(grid, tool.path);
  const bool disc = tool.brush == Paint::Brush::disc;
  VoxelBox allowed = whole_box(grid);
  if (disc) {
    const int slice = slice_of(indices, tool.normal_axis);
    for (Eigen::Vector3d& index : indices) index[tool.normal_axis] = slice;
    allowed.low[tool.normal_axis] = slice;
    allowed.high[tool.normal_axis] = slice + 1;
    allowed = intersection(allowed, whole_box(grid));
  }
  const double radius_mm = 1e3 * tool.radius;
  std::vector<Segment> segments;
  std::vector<VoxelBox> boxes;
  VoxelBox work{grid.size, Eigen::Vector3i::Zero()};
  for (std::size_t n = 0; n < indices.size(); ++n) {
    // A single point is a segment of length zero.
    if (n == 0 && indices.size() > 1) continue;
    const Eigen::Vector3d& from = indices[n == 0 ? 0 : n - 1];
    segments.push_back({from.cwiseProduct(grid.spacing_mm), indices[n].cwiseProduct(grid.spacing_mm),
                        radius_mm * radius_mm * (1.0 + 1e-9)});
    boxes.push_back(intersection(box_around(segments.back(), grid, radius_mm), allowed));
    if (boxes.back().empty()) continue;
    work.low = work.low.cwiseMin(boxes.back().low);
    work.high = work.high.cwiseMax(boxes.back().high);
  }
  Canvas canvas = task.canvas(work.empty() ? VoxelBox{} : work);
  std::optional<Surroundings> beside;
  const auto propose = [&](int i, int j, int k, Label old) -> Label {
    if (!tool.erase) return tool.label;
    if (tool.label != structure::kBackground && old != tool.label) return old;
    if (!lies_in_liver(tool.label)) return structure::kBackground;
    // Looked for when the first voxel is erased: a stroke beside the label costs nothing.
    if (!beside) beside.emplace(task.labels.voxels, work);
    return beside->at(i, j, k);
  };
  // The voxel under the pointer changes however small the brush is.
  const bool fine = radius_mm < 0.5 * grid.spacing_mm.norm();
  for (std::size_t n = 0; n < segments.size(); ++n) {
    if (task.context.cancelled()) return std::nullopt;
    if (boxes[n].empty()) continue;
    for_each_run(segments[n], grid, boxes[n],
                 [&](int j, int k, int i0, int i1) { canvas.rewrite_row(j, k, i0, i1, propose); });
    if (!fine) continue;
    const Eigen::Vector3d h = grid.spacing_mm;
    for_each_voxel_on(
        segments[n].a.cwiseQuotient(h), segments[n].b.cwiseQuotient(h), [&](const Eigen::Vector3i& v) {
          if ((v.array() >= boxes[n].low.array()).all() && (v.array() < boxes[n].high.array()).all())
            canvas.rewrite_row(v.y(), v.z(), v.x(), v.x() + 1, propose);
        });
  }
  return canvas;
}

const Names<Paint::Brush>& brushes() {
  static const Names<Paint::Brush> kNames = {{"disc", Paint::Brush::disc}, {"ball", Paint::Brush::ball}};
  return kNames;
}

Description<Paint> description() {
  return {"paint",
          10,
          {label_field<Paint>("label", &Paint::label, [](const Paint& t) { return t.erase; }),
           flag_field("erase", &Paint::erase), choice_field("brush", &Paint::brush, brushes()),
           length_field("radius_mm", &Paint::radius, kLargest),
           axis_field(&Paint::normal_axis)
               .needed("for a disc", [](const Paint& t) { return t.brush == Paint::Brush::disc; }),
           path_field(&Paint::path)},
          {"paint", "erase"},
          [](const Paint& t) {
            return StepName{t.erase ? "erase" : "paint", t.label, t.radius};
          },
          apply,
          [](const Paint&) { return true; }};
}

}  // namespace

bool Paint::operator==(const Paint& other) const {
  return label == other.label && erase == other.erase && brush == other.brush && radius == other.radius &&
         normal_axis == other.normal_axis && same_matrix(path, other.path);
}

const ToolKind& Paint::kind() {
  static const Described<Paint> kKind(description());
  return kKind;
}
const ToolKind& paint_tool() { return Paint::kind(); }

}  // namespace glisson::editing
