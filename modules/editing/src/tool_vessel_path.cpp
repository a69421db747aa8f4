// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/editing/tools/vessel_path.h"

#include <algorithm>
#include <cmath>

#include "describe.h"
#include "edit_shape.h"
#include "glisson/core/error.h"
#include "tube.h"

namespace glisson::editing {
namespace {

constexpr const char* kName = "vessel_path";
constexpr double kThinnest = 0.5e-3, kThickest = 8e-3;  ///< metres
constexpr double kFarthest = 0.1;                       ///< metres between consecutive points
/// How far beside the straight line a way may run: so much of its length, within limits; mm.
constexpr double kBeside = 0.25, kBesideLeast = 14.0, kBesideMost = 25.0;

std::string point_number(Eigen::Index n) { return "point " + std::to_string(n + 1); }

/// Which voxels the way may run through: those of the label, and those that it may take.
class Passable {
 public:
  Passable(const Task& task, Label label, const VoxelBox& box)
      : before_(task.labels.voxels), gate_(task.labels, task.image, task.region, box), label_(label) {}
  bool operator()(const Eigen::Vector3i& v) const {
    const Label old = before_.at(v);
    return old == label_ || (may_gain(label_, old) && gate_.open(v.x(), v.y(), v.z(), old, label_));
  }

 private:
  const LabelVolume& before_;
  Gate gate_;
  Label label_;
};

/// @throws InputError a point that no way can start from.
void check_end(const Task& task, const Passable& passable, const Part& part, const Eigen::Vector3i& voxel,
               Eigen::Index number) {
  const Eigen::Vector3d place = voxel.cast<double>().cwiseProduct(task.grid().spacing_mm);
  if (!is_tissue(task.image, part.at(place)))
    throw InputError(kName, "path", point_number(number) + " lies in air, fat or bone",
                     "Click inside the vessel");
  if (!passable(voxel))
    throw InputError(kName, "path",
                     point_number(number) + " lies in " + structure_name(task.labels.voxels.at(voxel)) +
                         ", which may not become the vessel there",
                     "Click beside it, or change what may be edited");
}

VoxelBox box_about(const Eigen::Vector3i& a, const Eigen::Vector3i& b, const VolumeGrid& grid) {
  const double length = (a - b).cast<double>().cwiseProduct(grid.spacing_mm).norm();
  const VoxelBox ends{a.cwiseMin(b), a.cwiseMax(b) + Eigen::Vector3i::Ones()};
  return grown(ends, grid, std::clamp(kBeside * length, kBesideLeast, kBesideMost));
}

/// The voxels of a tube. Neighbours on its line have a face in common, however thin it is.
class TubeVoxels {
 public:
  TubeVoxels(const VoxelBox& box, const Eigen::Vector3d& spacing_mm)
      : box_(box), mask_(box.size(), spacing_mm) {}

  void add_ball(const Eigen::Vector3d& place, double radius_mm) {
    const Eigen::Array3d h = mask_.spacing_mm.array();
    const Eigen::Vector3i low =
        ((place.array() - radius_mm) / h).ceil().matrix().cast<int>().cwiseMax(box_.low);
    const Eigen::Vector3i high = ((place.array() + radius_mm) / h)
                                     .floor()
                                     .matrix()
                                     .cast<int>()
                                     .cwiseMin(box_.high - Eigen::Vector3i::Ones());
    Eigen::Vector3i v;
    for (v.z() = low.z(); v.z() <= high.z(); ++v.z())
      for (v.y() = low.y(); v.y() <= high.y(); ++v.y())
        for (v.x() = low.x(); v.x() <= high.x(); ++v.x())
          if ((v.cast<double>().cwiseProduct(mask_.spacing_mm) - place).squaredNorm() <=
              radius_mm * radius_mm)
            add(v);
  }
  /// From the voxel that was added last, one axis after another.
  void add_line_to(const Eigen::Vector3i& v) {
    for (int axis = 0; axis < 3; ++axis)
      while (last_ && (*last_)[axis] != v[axis]) {
        (*last_)[axis] += v[axis] > (*last_)[axis] ? 1 : -1;
        add(*last_);
      }
    add(v);
    last_ = v;
  }
  bool has(int i, int j, int k) const {
    return mask_.voxels[mask_.offset(i - box_.low.x(), j - box_.low.y(), k - box_.low.z())] != 0;
  }

 private:
  void add(const Eigen::Vector3i& v) {
    if (((v - box_.low).array() >= 0).all() && ((v - box_.high).array() < 0).all())
      mask_.voxels[mask_.offset(v.x() - box_.low.x(), v.y() - box_.low.y(), v.z() - box_.low.z())] = 1;
  }

  VoxelBox box_;
  Mask mask_;
  std::optional<Eigen::Vector3i> last_;
};

struct Drawn {
  double places = 0.0, seen = 0.0;  ///< places of all stretches, and those with a radius in the image
};

/// From one point to the next. @returns false when cancelled.
bool add_stretch(const VesselPath& tool, const Task& task, const Eigen::Vector3i& from,
                 const Eigen::Vector3i& to, Eigen::Index number, const RunContext& context,
                 TubeVoxels& voxels, Drawn& drawn) {
  const VolumeGrid& grid = task.grid();
  const VoxelBox box = box_about(from, to, grid);
  const Passable passable(task, tool.label, box);
  const Part part = smoothed_part(task.image, box, 0.5);
  check_end(task, passable, part, from, number);
  check_end(task, passable, part, to, number + 1);
  const auto place = [&](const Eigen::Vector3i& v) { return v.cast<double>().cwiseProduct(grid.spacing_mm); };
  const Looks looks = looks_at(task.image, part, place(from), place(to));
  const auto way = cheapest_way(task.image, box, from, to, looks, passable, context.part(0.0, 0.8));
  if (!way) return false;
  if (way->empty())
    throw InputError(kName, "path",
                     "has no way from " + point_number(number) + " to " + point_number(number + 1) +
                         " through soft tissue that may become the vessel",
                     "Click points between them, or change what may be edited");
  const double smallest = std::max(1e3 * kThinnest, 0.5 * grid.spacing_mm.minCoeff());
  const double largest = std::max(smallest, 1e3 * tool.largest_radius);
  const Tube tube = tube_about(task.image, part, *way, looks, smallest, largest);
  drawn.places += static_cast<double>(tube.places.size());
  drawn.seen += tube.seen * static_cast<double>(tube.places.size());
  bool beside = false;
  for (std::size_t n = 0; n < tube.places.size(); ++n) {
    const Eigen::Vector3i v =
        tube.places[n].cwiseQuotient(grid.spacing_mm).array().round().matrix().cast<int>();
    voxels.add_ball(tube.places[n], tube.radii_mm[n]);
    voxels.add_line_to(v);
    beside = beside || !grid.contains(v) || !passable(v);
  }
  // Where the middle lies in what may not change the way itself joins the parts.
  if (beside) {
    voxels.add_line_to(way->back());
    for (auto v = way->rbegin(); v != way->rend(); ++v) voxels.add_line_to(*v);
  }
  voxels.add_line_to(to);
  context.progress(1.0, "segmentation.edit");
  return true;
}

bool is_vessel(Label label) {
  return label == structure::kPortalVein || label == structure::kHepaticVeins ||
         label == structure::kVenaCava || label == structure::kArtery;
}

Cancellable<Canvas> apply(const VesselPath& tool, Task& task) {
  if (!is_vessel(tool.label))
    throw InputError(kName, "label", "is " + structure_name(tool.label) + ", which is no vessel",
                     "Choose the portal vein, the hepatic veins, the vena cava or the artery");
  const VolumeGrid& grid = task.grid();
  std::vector<Eigen::Vector3i> points;
  for (Eigen::Index n = 0; n < tool.path.rows(); ++n) {
    const Eigen::Vector3d index =
        grid.index_of(Point<CtFrame>(Eigen::Vector3d(tool.path.row(n).transpose())));
    const Eigen::Array3d rounded = index.array().round();
    if ((rounded < 0.0).any() || (rounded >= grid.size.array().cast<double>()).any())
      throw InputError(kName, "path", point_number(n) + " lies outside the volume",
                       "Click inside the picture");
    points.emplace_back(rounded.matrix().cast<int>());
    if (n > 0 && points[static_cast<std::size_t>(n)] == points[static_cast<std::size_t>(n) - 1])
      throw InputError(kName, "path", point_number(n - 1) + " and " + point_number(n) + " are one voxel",
                       "Click two different places");
  }
  VoxelBox box{points.front(), points.front() + Eigen::Vector3i::Ones()};
  for (std::size_t n = 1; n < points.size(); ++n) {
    const VoxelBox stretch = box_about(points[n - 1], points[n], grid);
    box = {box.low.cwiseMin(stretch.low), box.high.cwiseMax(stretch.high)};
  }
  TubeVoxels voxels(box, grid.spacing_mm);
  Drawn drawn;
  const auto stretches = static_cast<double>(points.size() - 1);
  for (std::size_t n = 1; n < points.size(); ++n) {
    const double before = static_cast<double>(n - 1) / stretches, after = static_cast<double>(n) / stretches;
    if (!add_stretch(tool, task, points[n - 1], points[n], static_cast<Eigen::Index>(n) - 1,
                     task.context.part(0.9 * before, 0.9 * after), voxels, drawn))
      return std::nullopt;
  }
  if (drawn.seen <= 0.0)
    task.notes.emplace_back("vessel_path.radius_unseen");
  else if (drawn.seen < 0.5 * drawn.places)
    task.notes.emplace_back("vessel_path.faint:" +
                            std::to_string(std::lround(100.0 * (1.0 - drawn.seen / drawn.places))));
  Canvas canvas = task.canvas(box);
  const bool done = canvas.rewrite(box, task.context.part(0.9, 1.0), [&](int i, int j, int k, Label old) {
    return may_gain(tool.label, old) && voxels.has(i, j, k) ? tool.label : old;
  });
  if (!done) return std::nullopt;
  return canvas;
}

void check_points(const SettingsCheck& check, const VesselPath& t) {
  if (t.path.rows() < 2) check.refuse("path", "has fewer than two points", "Give the two ends of the gap");
  for (Eigen::Index n = 0; n < t.path.rows(); ++n) {
    check.point(t.path.row(n).transpose(), "path");
    if (n == 0) continue;
    const double apart = (t.path.row(n) - t.path.row(n - 1)).norm();
    if (apart <= 0.0)
      check.refuse("path",
                   "has the same place twice (" + point_number(n - 1) + " and " + point_number(n) + ")",
                   "Click two different places");
    if (apart > kFarthest)
      check.refuse("path",
                   "leaves " + millimetres(apart) + " between " + point_number(n - 1) + " and " +
                       point_number(n) + ", more than 100 mm",
                   "Click points between them");
  }
}

Description<VesselPath> description() {
  return {kName,
          130,
          {label_field("label", &VesselPath::label), path_field(&VesselPath::path).checked(check_points),
           length_field("largest_radius_mm", &VesselPath::largest_radius, kThickest)
               .with_default()
               .checked([](const SettingsCheck& check, const VesselPath& t) {
                 check.length(t.largest_radius, "largest_radius", kThickest);
                 if (t.largest_radius < kThinnest)
                   check.refuse("largest_radius", "is below 0.5 mm", "Choose 0.5 to 8 mm");
               })},
          {kName},
          [](const VesselPath& t) {
            return StepName{kName, t.label, 0.0};
          },
          apply};
}

}  // namespace

bool VesselPath::operator==(const VesselPath& other) const {
  return label == other.label && largest_radius == other.largest_radius && same_matrix(path, other.path);
}

const ToolKind& VesselPath::kind() {
  static const Described<VesselPath> kKind(description());
  return kKind;
}
const ToolKind& vessel_path_tool() { return VesselPath::kind(); }

}  // namespace glisson::editing
