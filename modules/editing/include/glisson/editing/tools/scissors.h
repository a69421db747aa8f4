// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

#include "glisson/editing/tool.h"
#include "glisson/patient/label_map.h"

namespace glisson::editing {

/// A closed line drawn over a view, in a slice or in three dimensions: what lies behind it, or beside it.
/// Inside is what the line winds about, so that overlapping ends cut no hole; what is behind the viewer is
/// outside. Overwrites; erases.
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

}  // namespace glisson::editing
