// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "edit_naive.h"

namespace glisson::test {

/// A view in perspective from a point looking along +z; places are tangents.
inline Eigen::Matrix<double, 3, 4> seen_from(const Eigen::Vector3d& eye) {
  Eigen::Matrix<double, 3, 4> view;
  view << Eigen::Matrix3d::Identity(), -eye;
  return view;
}
inline Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor> circle(double radius, int corners = 200,
                                                                        const Eigen::Vector2d& centre = {
                                                                            0.0, 0.0}) {
  Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor> outline(corners, 2);
  for (int n = 0; n < corners; ++n)
    outline.row(n) = (centre + radius * Eigen::Vector2d(std::cos(2 * M_PI * n / corners),
                                                        std::sin(2 * M_PI * n / corners)))
                         .transpose();
  return outline;
}

/// Settings of one of the tools that the naive ones are compared with, at random.
class RandomEdits {
 public:
  RandomEdits(const VolumeGrid& grid, unsigned seed) : grid_(grid), random_(seed) {}

  Edit next() {
    Edit edit{tool(), region()};
    // Locking what is edited is refused; see edit_script_test.
    std::erase_if(edit.region.locked, [&](Label label) {
      return of_settings(edit.tool, [&](const auto& t) { return names(t, label); });
    });
    return edit;
  }

 private:
  static bool names(const Logical& t, Label label) { return label == t.label || label == t.other; }
  template <class T>
  static bool names(const T& t, Label label) {
    if constexpr (requires { t.label; }) return label == t.label;
    return false;
  }
  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  /// Drawn from the last coordinate to the first.
  Eigen::Vector3d between3(double low, double high) {
    const double z = between(low, high), y = between(low, high), x = between(low, high);
    return {x, y, z};
  }
  Label label() {
    static constexpr std::array<Label, 6> kLabels = {1, 2, 3, 4, 16, 17};
    return kLabels[static_cast<std::size_t>(below(6))];
  }
  Eigen::Vector3d place(double beyond = 0.0) {
    Eigen::Vector3d p;
    for (int axis = 0; axis < 3; ++axis)
      p[axis] = between(-beyond, (grid_.size[axis] - 1) * grid_.spacing_mm[axis] + beyond);
    return p;
  }
  Paint paint() {
    Paint t;
    t.label = label();
    t.erase = below(3) == 0;
    if (t.erase && below(2) == 0) t.label = 0;
    t.brush = below(2) == 0 ? Paint::Brush::disc : Paint::Brush::ball;
    t.radius = between(1.2e-3, 9e-3);
    t.normal_axis = below(3);
    t.path.resize(1 + below(4), 3);
    Eigen::Vector3d at = place(5.0);
    const double slice = grid_.spacing_mm[t.normal_axis] * below(grid_.size[t.normal_axis]);
    for (Eigen::Index n = 0; n < t.path.rows(); ++n) {
      at += between3(-6, 6);
      if (t.brush == Paint::Brush::disc)
        at[t.normal_axis] = slice + between(-0.2, 0.2) * grid_.spacing_mm[t.normal_axis];
      t.path.row(n) = p_at(grid_, at).transpose();
    }
    return t;
  }
  Scissors scissors() {
    Scissors t;
    t.label = label();
    t.operation = static_cast<Scissors::Operation>(below(3));
    const Eigen::Vector3d towards = p_at(grid_, place());
    if (below(2) == 0) {  // a slice, or a parallel view
      const Eigen::Vector3d q = between3(-1, 1);
      t.view_from_ct
          << Eigen::Quaterniond(q.x(), q.y(), q.z(), 0.5).normalized().toRotationMatrix().topRows<2>(),
          Eigen::Vector2d::Zero(), 0, 0, 0, 1;
    } else {
      t.view_from_ct = seen_from(towards - Eigen::Vector3d(0.0, 0.0, between(-0.01, 0.08)));
    }
    const Eigen::Vector2d centre = t.view_from_ct.row(2).head<3>().isZero()
                                       ? Eigen::Vector2d((t.view_from_ct * towards.homogeneous()).head<2>())
                                       : Eigen::Vector2d(0.0, 0.0);
    t.outline = circle(t.view_from_ct.row(2).head<3>().isZero() ? 0.01 : 0.2, 3 + below(6), centre);
    // A star that crosses itself is wound about, too.
    if (below(2) == 0)
      for (Eigen::Index n = 0; n < t.outline.rows(); n += 2)
        t.outline.row(n) = centre.transpose() + 0.3 * (t.outline.row(n) - centre.transpose());
    if (below(2) == 0) {
      t.slab = Scissors::Slab();
      t.slab->normal = between3(-1, 1).normalized();
      t.slab->offset = t.slab->normal.dot(towards);
      t.slab->half_thickness = between(0.5e-3, 8e-3);
    }
    return t;
  }
  Tool tool() {
    switch (below(9)) {
      case 0:
        return Threshold{label(), between(-60, 20), between(20, 90), below(2) == 0};
      case 1:
        return scissors();
      case 2:
        return Logical{label(), static_cast<Logical::Operation>(below(7)),
                       below(3) == 0 ? Label{0} : label()};
      case 3:
        return Islands{label(), static_cast<Islands::Operation>(below(2) == 0 ? 4 : below(2)),
                       between(0.01, 0.2), p_at(grid_, place())};
      case 4:
        return FillHoles{label(), below(2) == 0};
      case 5:
        return Smooth{label(), static_cast<Smooth::Method>(below(3)), between(1.2e-3, 3.1e-3)};
      case 6:
        return Margin{label(), (below(2) == 0 ? 1 : -1) * between(0.8e-3, 3.4e-3)};
      default:
        return paint();
    }
  }
  EditableRegion region() {
    EditableRegion r;
    r.area = static_cast<EditableRegion::Area>(below(5));
    if (below(2) == 0) r.area = EditableRegion::Area::everywhere;
    r.label = label();
    if (below(3) == 0) r.intensity = std::array<double, 2>{between(-50, 0), between(0, 80)};
    for (int n = below(3); n > 0; --n) r.locked.push_back(below(6) == 0 ? Label{0} : label());
    return r;
  }

  VolumeGrid grid_;
  std::mt19937 random_;
};

}  // namespace glisson::test
