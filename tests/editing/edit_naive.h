// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <random>
#include <tuple>

#include "glisson/editing/edit.h"
#include "glisson/editing/tools/fill_holes.h"
#include "glisson/editing/tools/grow.h"
#include "glisson/editing/tools/interpolate.h"
#include "glisson/editing/tools/islands.h"
#include "glisson/editing/tools/level_tracing.h"
#include "glisson/editing/tools/logical.h"
#include "glisson/editing/tools/margin.h"
#include "glisson/editing/tools/paint.h"
#include "glisson/editing/tools/reassign.h"
#include "glisson/editing/tools/scissors.h"
#include "glisson/editing/tools/smooth.h"
#include "glisson/editing/tools/threshold.h"
#include "glisson/volume/morphology.h"

/// What the editing tools should do, written as one would on dense arrays with all the time in the world.
namespace glisson::test {

using namespace glisson::editing;

/// Grids that a tool must not notice: rotated, and stored the wrong way round. Voxels are no cubes and the
/// sizes no multiples of a brick's.
inline std::vector<VolumeGrid> awkward_grids() {
  VolumeGrid straight;
  straight.size = {47, 38, 35};
  straight.spacing_mm = {0.7, 1.1, 1.6};
  straight.origin_mm = {-31.0, 17.0, 402.5};
  VolumeGrid oblique = straight;
  oblique.direction = Eigen::AngleAxisd(0.4, Eigen::Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  VolumeGrid flipped = oblique;
  flipped.direction.col(1) *= -1.0;
  return {straight, oblique, flipped};
}

inline Image image_of(const VolumeGrid& grid, const std::function<double(const Eigen::Vector3i&)>& value) {
  std::vector<std::int16_t> voxels;
  for (int k = 0; k < grid.size.z(); ++k)
    for (int j = 0; j < grid.size.y(); ++j)
      for (int i = 0; i < grid.size.x(); ++i)
        voxels.push_back(static_cast<std::int16_t>(std::lround(value({i, j, k}))));
  Image image;
  image.grid = grid;
  image.voxels = std::make_shared<const std::vector<std::int16_t>>(std::move(voxels));
  return image;
}

inline LabelMap labels_of(const VolumeGrid& grid, const std::function<Label(const Eigen::Vector3i&)>& value) {
  std::vector<Label> dense;
  for (int k = 0; k < grid.size.z(); ++k)
    for (int j = 0; j < grid.size.y(); ++j)
      for (int i = 0; i < grid.size.x(); ++i) dense.push_back(value({i, j, k}));
  return {LabelVolume(grid, dense), {}};
}

/// Middle of the volume, millimetres along the voxel axes (index times spacing).
inline Eigen::Vector3d middle_of(const VolumeGrid& grid) {
  return 0.5 * (grid.size - Eigen::Vector3i::Ones()).cast<double>().cwiseProduct(grid.spacing_mm);
}
inline Eigen::Vector3d place_of(const VolumeGrid& grid, const Eigen::Vector3i& v) {
  return v.cast<double>().cwiseProduct(grid.spacing_mm);
}
/// A place in millimetres along the voxel axes as a point of the CT.
inline Eigen::Vector3d p_at(const VolumeGrid& grid, const Eigen::Vector3d& place_mm) {
  return grid.p_in_ct(place_mm.cwiseQuotient(grid.spacing_mm)).xyz;
}

/// A liver of some 14 mm with two trees, a lesion, a cavity and a cava beside it; crumbs of everything about.
inline LabelMap small_anatomy(const VolumeGrid& grid, unsigned seed) {
  std::mt19937 random(seed);
  const Eigen::Vector3d c = middle_of(grid);
  return labels_of(grid, [&](const Eigen::Vector3i& v) -> Label {
    const Eigen::Vector3d p = place_of(grid, v) - c;
    const unsigned crumb = random() % 400;
    if (std::hypot(p.y() - 3.0, p.z()) < 2.0 && p.x() > -9.0) return structure::kPortalVein;
    if (std::hypot(p.x() + 3.0, p.z() - 4.0) < 1.7 && p.y() < 8.0) return structure::kHepaticVeins;
    if ((p - Eigen::Vector3d(4.0, -5.0, 2.0)).norm() < 3.5) return structure::kFirstLesion;
    if ((p - Eigen::Vector3d(-5.0, -4.0, -6.0)).norm() < 2.2) return structure::kBackground;
    if (p.cwiseQuotient(Eigen::Vector3d(12.0, 13.0, 15.0)).norm() < 1.0)
      return crumb == 0 ? structure::kBackground : structure::kParenchyma;
    if (std::hypot(p.x() - 12.0, p.y() - 12.0) < 3.0) return structure::kVenaCava;
    return crumb < 2 ? static_cast<Label>(1 + crumb) : structure::kBackground;
  });
}

/// What `visit` says to the settings of a tool. @pre it is one of these.
template <class Visit>
auto of_settings(const Tool& tool, Visit&& visit) {
  std::optional<decltype(visit(Paint()))> said;
  const auto try_all = [&]<class... Settings>(std::tuple<Settings...>*) {
    ((tool.get_if<Settings>() != nullptr ? (void)(said = visit(tool.as<Settings>())) : (void)0), ...);
  };
  using All = std::tuple<Paint, Threshold, Scissors, GrowFromSeeds, LevelTracing, Islands, FillHoles, Smooth,
                         Margin, InterpolateSlices, Logical, ReassignBranch>;
  try_all(static_cast<All*>(nullptr));
  return said.value();
}

/// An edit on dense arrays.
class Naive {
 public:
  Naive(const LabelMap& labels, const Image& image)
      : map_(labels), image_(image), grid_(image.grid), before_(labels.voxels.dense()) {}

  std::vector<Label> apply(const Edit& edit) const {
    std::vector<Label> after = of_settings(edit.tool, [&](const auto& tool) { return wanted(tool); });
    for (std::size_t at = 0; at < after.size(); ++at)
      if (after[at] != before_[at] && !allowed(edit.region, at, after[at])) after[at] = before_[at];
    return after;
  }
  bool allowed(const EditableRegion& region, std::size_t at, Label to) const {
    const Label from = before_[at];
    for (const Label locked : region.locked)
      if (from == locked || to == locked) return false;
    const double hu = (*image_.voxels)[at];
    if (region.intensity && (hu < (*region.intensity)[0] || hu > (*region.intensity)[1])) return false;
    switch (region.area) {
      case EditableRegion::Area::labelled:
        return from != 0;
      case EditableRegion::Area::unlabelled:
        return from == 0;
      case EditableRegion::Area::inside_label:
        return from == region.label;
      case EditableRegion::Area::inside_liver:
        if (liver_.empty()) liver_ = inside_liver(map_);
        return liver_[at] != 0;
      default:
        return true;
    }
  }
  const std::vector<Label>& before() const { return before_; }

 private:
  using Voxel = Eigen::Vector3i;
  template <class F>
  std::vector<Label> each(F&& f) const {
    std::vector<Label> after = before_;
    std::size_t at = 0;
    for (int k = 0; k < grid_.size.z(); ++k)
      for (int j = 0; j < grid_.size.y(); ++j)
        for (int i = 0; i < grid_.size.x(); ++i, ++at) after[at] = f(Voxel(i, j, k), before_[at]);
    return after;
  }
  std::size_t at(const Voxel& v) const { return static_cast<std::size_t>(grid_.offset(v)); }
  Label erased(Label wanted, Label old) const { return wanted == 0 || wanted == old ? Label{0} : old; }

  std::vector<Label> wanted(const Paint& t) const {
    return each([&](const Voxel& v, Label old) {
      const Eigen::Vector3d p = grid_.p_in_ct(v.cast<double>()).xyz;
      double nearest = 1e30;
      for (Eigen::Index n = 0; n < t.path.rows(); ++n) {
        Eigen::Vector3d a = t.path.row(std::max<Eigen::Index>(n - 1, 0)).transpose();
        Eigen::Vector3d b = t.path.row(n).transpose();
        if (n == 0 && t.path.rows() > 1) continue;
        if (t.brush == Paint::Brush::disc) {
          // Only the disc's own slice; distances are those within it.
          Eigen::Vector3d ia = grid_.index_of(Point<CtFrame>(a)), ib = grid_.index_of(Point<CtFrame>(b));
          if (std::lround(ia[t.normal_axis]) != v[t.normal_axis]) return old;
          ia[t.normal_axis] = ib[t.normal_axis] = v[t.normal_axis];
          a = grid_.p_in_ct(ia).xyz;
          b = grid_.p_in_ct(ib).xyz;
        }
        const double s = a == b ? 0.0 : std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
        nearest = std::min(nearest, (p - a - s * (b - a)).norm());
      }
      if (nearest > t.radius) return old;
      if (!t.erase) return t.label;
      const bool in_liver = t.label == 2 || t.label == 3 || t.label == 5 || is_lesion(t.label);
      return in_liver && old == t.label ? nearer(v) : erased(t.label, old);
    });
  }
  /// The nearer one of parenchyma and background, looking at every voxel.
  Label nearer(const Voxel& v) const {
    double tissue = 1e30, background = 1e30;
    std::size_t n = 0;
    for (int k = 0; k < grid_.size.z(); ++k)
      for (int j = 0; j < grid_.size.y(); ++j)
        for (int i = 0; i < grid_.size.x(); ++i, ++n) {
          const double far2 =
              (Voxel(i, j, k) - v).cast<double>().cwiseProduct(grid_.spacing_mm).squaredNorm();
          if (before_[n] == structure::kParenchyma) tissue = std::min(tissue, far2);
          if (before_[n] == 0) background = std::min(background, far2);
        }
    // Single precision on the other side: what is equal to a millionth is equally near.
    return tissue <= background * (1.0 + 1e-6) ? structure::kParenchyma : structure::kBackground;
  }

  std::vector<Label> wanted(const Threshold& t) const {
    return each([&](const Voxel& v, Label old) -> Label {
      if (image_.at(v) >= t.low && image_.at(v) <= t.high) return t.label;
      return t.replace && old == t.label ? Label{0} : old;
    });
  }

  std::vector<Label> wanted(const Scissors& t) const {
    const auto cut = [&](const Voxel& v, Label old) -> Label {
      const Eigen::Vector3d p = grid_.p_in_ct(v.cast<double>()).xyz;
      if (t.slab && std::abs(t.slab->normal.dot(p) - t.slab->offset) > t.slab->half_thickness) return old;
      const Eigen::Vector3d seen = t.view_from_ct * p.homogeneous();
      // Winding number as the sum of the angles under which the edges are seen.
      double turned = 0.0;
      for (Eigen::Index n = 0; n < t.outline.rows() && seen.z() > 0.0; ++n) {
        const Eigen::Vector2d a = t.outline.row(n).transpose() - seen.hnormalized();
        const Eigen::Vector2d b = t.outline.row((n + 1) % t.outline.rows()).transpose() - seen.hnormalized();
        turned += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
      }
      const bool inside = std::abs(turned) > M_PI;
      if (t.operation == Scissors::Operation::fill_inside) return inside ? t.label : old;
      return inside == (t.operation == Scissors::Operation::erase_inside) ? erased(t.label, old) : old;
    };
    return leaving_no_hole(each(cut), t.label);
  }

  std::vector<Label> wanted(const Islands& t) const {
    Mask mask(grid_.size, grid_.spacing_mm);
    for (std::size_t n = 0; n < before_.size(); ++n) mask.voxels[n] = before_[n] == t.label;
    std::vector<long> sizes;
    const std::vector<int> number = connected_components(mask, sizes);
    const int clicked =
        number[at(grid_.index_of(Point<CtFrame>(t.p_in_ct)).array().round().matrix().cast<int>())];
    std::vector<Label> free;
    for (Label label = is_lesion(t.label) ? 16 : 7; label <= (is_lesion(t.label) ? 255 : 15); ++label)
      if (std::find(before_.begin(), before_.end(), label) == before_.end()) free.push_back(label);
    const auto fate = [&](const Voxel& v, Label old) -> Label {
      const int n = number[at(v)];
      if (n == 0) return old;
      const double ml =
          1e-3 * static_cast<double>(sizes[static_cast<std::size_t>(n - 1)]) * grid_.voxel_volume_mm3();
      switch (t.operation) {
        case Islands::Operation::keep_largest:
          return n == 1 ? old : Label{0};
        case Islands::Operation::remove_small:
          return ml < t.smallest_ml ? Label{0} : old;
        case Islands::Operation::keep_clicked:
          return n == clicked ? old : Label{0};
        case Islands::Operation::remove_clicked:
          return n == clicked ? Label{0} : old;
        default:
          return n == 1 || n - 2 >= static_cast<int>(free.size()) ? old
                                                                  : free[static_cast<std::size_t>(n - 2)];
      }
    };
    return leaving_no_hole(each(fate), t.label);
  }
  /// What a vessel or a lesion has lost becomes the nearer one of parenchyma and background.
  std::vector<Label> leaving_no_hole(const std::vector<Label>& after, Label label) const {
    if (label != 2 && label != 3 && label != 5 && !is_lesion(label)) return after;
    return each([&](const Voxel& v, Label old) {
      return old == label && after[at(v)] == 0 ? nearer(v) : after[at(v)];
    });
  }

  bool in_shape(Label label, Label of) const {
    if (of != structure::kParenchyma) return label == of;
    return label == 1 || label == 2 || label == 3 || label == 5 || is_lesion(label);
  }
  Mask shape(Label of) const {
    Mask mask(grid_.size, grid_.spacing_mm);
    for (std::size_t n = 0; n < before_.size(); ++n) mask.voxels[n] = in_shape(before_[n], of);
    return mask;
  }
  /// The label takes on the shape as edit.h says.
  std::vector<Label> reshaped(const Mask& mask, Label label) const {
    std::vector<Label> after = before_;
    std::vector<std::size_t> lost;
    for (std::size_t n = 0; n < before_.size(); ++n) {
      const bool gains = before_[n] == 0 || (before_[n] == 1 && label != 1);
      if (mask.voxels[n] != 0 && gains) after[n] = label;
      if (mask.voxels[n] == 0 && before_[n] == label) lost.push_back(n);
    }
    if (label == 1) {
      for (const std::size_t n : lost) after[n] = 0;
      return after;
    }
    const std::vector<int> from_tissue = steps_from(1, lost), from_air = steps_from(0, lost);
    for (const std::size_t n : lost)
      after[n] = from_tissue[n] <= from_air[n] && from_tissue[n] < 1000000 ? 1 : 0;
    return after;
  }
  /// Steps through faces of lost voxels from those that had `label`, by relaxation until nothing changes.
  std::vector<int> steps_from(Label label, const std::vector<std::size_t>& lost) const {
    std::vector<int> steps(before_.size(), 1000000);
    std::vector<bool> is_lost(before_.size(), false);
    for (const std::size_t n : lost) is_lost[n] = true;
    for (std::size_t n = 0; n < before_.size(); ++n)
      if (before_[n] == label && !is_lost[n]) steps[n] = 0;
    for (bool changed = true; changed;) {
      changed = false;
      for (const std::size_t n : lost) {
        const auto nx = static_cast<std::size_t>(grid_.size.x()),
                   ny = static_cast<std::size_t>(grid_.size.y());
        const Voxel v(static_cast<int>(n % nx), static_cast<int>(n / nx % ny),
                      static_cast<int>(n / (nx * ny)));
        for (int side = 0; side < 6; ++side) {
          Voxel w = v;
          w[side / 2] += side % 2 == 0 ? 1 : -1;
          if (!grid_.contains(w) || steps[at(w)] + 1 >= steps[n]) continue;
          steps[n] = steps[at(w)] + 1;
          changed = true;
        }
      }
    }
    return steps;
  }

  std::vector<Label> wanted(const FillHoles& t) const {
    return reshaped(t.in_slices ? slice_holes_filled(shape(t.label)) : holes_filled(shape(t.label)), t.label);
  }

  /// Calls visit(voxel) for the voxels of the volume within a ball.
  template <class Visit>
  void in_ball(const Voxel& v, double radius_mm, Visit&& visit) const {
    const Voxel reach = (radius_mm / grid_.spacing_mm.array()).ceil().matrix().cast<int>();
    for (int k = -reach.z(); k <= reach.z(); ++k)
      for (int j = -reach.y(); j <= reach.y(); ++j)
        for (int i = -reach.x(); i <= reach.x(); ++i) {
          const Voxel w = v + Voxel(i, j, k);
          if (grid_.contains(w) &&
              Eigen::Vector3d(i, j, k).cwiseProduct(grid_.spacing_mm).norm() <= radius_mm)
            visit(w);
        }
  }
  std::vector<Label> wanted(const Smooth& t) const {
    const double r = 1e3 * t.radius;
    const Mask mask = shape(t.label);
    if (t.method == Smooth::Method::closing) return reshaped(closed(mask, r), t.label);
    if (t.method == Smooth::Method::opening) return reshaped(opened(mask, r), t.label);
    Mask smooth = mask;
    each([&](const Voxel& v, Label old) {
      int in = 0, all = 0;
      in_ball(v, r, [&](const Voxel& w) { in += mask.voxels[at(w)], ++all; });
      if (2 * in != all) smooth.voxels[at(v)] = 2 * in > all;
      return old;
    });
    return reshaped(smooth, t.label);
  }

  std::vector<Label> wanted(const Margin& t) const {
    const double d = 1e3 * std::abs(t.distance);
    Mask mask = shape(t.label);
    if (t.distance > 0.0 && t.label == 1)
      for (std::size_t n = 0; n < before_.size(); ++n)
        mask.voxels[n] = before_[n] == 1 || is_lesion(before_[n]);
    Mask moved = mask;
    const std::uint8_t spreads = t.distance > 0.0 ? 1 : 0;
    each([&](const Voxel& v, Label old) {
      in_ball(v, d, [&](const Voxel& w) {
        if (mask.voxels[at(w)] == spreads) moved.voxels[at(v)] = spreads;
      });
      return old;
    });
    return reshaped(moved, t.label);
  }

  /// Distance in a slice to the label, minus that to what is not the label.
  double signed_distance(const Voxel& v, int slice, const InterpolateSlices& t) const {
    double to_label = 1e4, to_rest = 1e4;
    Voxel w;
    const int u1 = (t.normal_axis + 1) % 3, u2 = (t.normal_axis + 2) % 3;
    w[t.normal_axis] = slice;
    for (w[u1] = 0; w[u1] < grid_.size[u1]; ++w[u1])
      for (w[u2] = 0; w[u2] < grid_.size[u2]; ++w[u2]) {
        const double d =
            std::hypot((w[u1] - v[u1]) * grid_.spacing_mm[u1], (w[u2] - v[u2]) * grid_.spacing_mm[u2]);
        double& nearest = before_[at(w)] == t.label ? to_label : to_rest;
        nearest = std::min(nearest, d);
      }
    return to_label - to_rest;
  }
  std::vector<Label> wanted(const InterpolateSlices& t) const {
    std::vector<bool> drawn(static_cast<std::size_t>(grid_.size[t.normal_axis]), false);
    each([&](const Voxel& v, Label old) {
      if (old == t.label) drawn[static_cast<std::size_t>(v[t.normal_axis])] = true;
      return old;
    });
    Mask mask = shape(t.label);
    for (std::size_t n = 0; n < before_.size(); ++n) mask.voxels[n] = before_[n] == t.label;
    each([&](const Voxel& v, Label old) {
      int low = v[t.normal_axis], high = low;
      while (low >= 0 && !drawn[static_cast<std::size_t>(low)]) --low;
      while (high < grid_.size[t.normal_axis] && !drawn[static_cast<std::size_t>(high)]) ++high;
      if (low == high || low < 0 || high == grid_.size[t.normal_axis]) return old;
      const double s = static_cast<double>(v[t.normal_axis] - low) / (high - low);
      const double d = (1.0 - s) * signed_distance(v, low, t) + s * signed_distance(v, high, t);
      if (d < -1e-4) mask.voxels[at(v)] = 1;
      return old;
    });
    return reshaped(mask, t.label);
  }

  std::vector<Label> wanted(const Logical& t) const {
    return each([&](const Voxel&, Label old) -> Label {
      const bool a = old == t.label, b = old == t.other;
      bool in = a;
      switch (t.operation) {
        case Logical::Operation::copy:
          in = b;
          break;
        case Logical::Operation::add:
          in = a || b;
          break;
        case Logical::Operation::subtract:
          in = a && !b;
          break;
        case Logical::Operation::intersect:
          in = a && b;
          break;
        case Logical::Operation::invert:
          in = !a;
          break;
        case Logical::Operation::clear:
          in = false;
          break;
        case Logical::Operation::fill:
          in = true;
          break;
      }
      return in ? t.label : a ? Label{0} : old;
    });
  }

  // Compared otherwise: see the tests of each.
  std::vector<Label> wanted(const GrowFromSeeds&) const { return before_; }
  std::vector<Label> wanted(const LevelTracing&) const { return before_; }
  std::vector<Label> wanted(const ReassignBranch&) const { return before_; }

  const LabelMap& map_;
  const Image& image_;
  VolumeGrid grid_;
  std::vector<Label> before_;
  mutable std::vector<std::uint8_t> liver_;
};

/// What is wrong with the result of an edit, told against the naive one; "" when nothing is.
inline std::string fault_of(const LabelMap& labels, const Image& image, const Edit& edit) {
  const Edited edited = apply_edit(labels, image, edit, RunContext()).value();
  const Naive naive(labels, image);
  const std::vector<Label> before = naive.before(), expected = naive.apply(edit),
                           after = edited.labels.voxels.dense();
  long changed = 0;
  for (std::size_t n = 0; n < after.size(); ++n) {
    if (after[n] != expected[n])
      return "voxel " + std::to_string(n) + " was " + std::to_string(before[n]) + ", is " +
             std::to_string(after[n]) + " and should be " + std::to_string(expected[n]);
    changed += after[n] != before[n];
  }
  if (changed != edited.voxels_changed) return "the changes are miscounted";
  if ((changed == 0) != (!edited.notes.empty() && edited.notes.back() == "nothing_changed"))
    return "nothing_changed is said wrongly";
  // Exactly the bricks that changed are new.
  const auto bricks = static_cast<int>(edited.labels.voxels.changes_since(labels.voxels).size());
  if (bricks != edited.labels.voxels.bricks_differing_from(labels.voxels))
    return "an unchanged brick was copied";
  for (std::size_t n = 0; n < after.size(); ++n) {
    if (after[n] == before[n] || after[n] == 0) continue;
    const auto known = [&](const LabelInfo& info) { return info.code == after[n] && !info.name.empty(); };
    if (std::count_if(edited.labels.infos.begin(), edited.labels.infos.end(), known) != 1)
      return "label " + std::to_string(after[n]) + " has no information";
  }
  return "";
}

}  // namespace glisson::test
