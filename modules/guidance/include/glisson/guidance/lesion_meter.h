// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "glisson/core/json_file.h"
#include "glisson/patient/patient_model.h"

namespace glisson::guidance {

/// A surface that goes where the model's mesh goes.
struct CarriedSurface {
  Label structure = 0;
  TriangleMesh mesh;  ///< CT frame, at rest
  Binding binding;    ///< of its vertices to the model's mesh
};

/// A place of the organ's surface, which moves with its tissue.
struct SurfacePlace {
  int triangle = -1;
  Eigen::Vector3d weights = Eigen::Vector3d::Zero();
  bool operator==(const SurfacePlace&) const = default;
};

/// Metres, camera frame. Not a number: cannot be said.
struct LesionMeasures {
  Label lesion = 0;
  /// From where the line of sight to the lesion's centre enters the organ to where it meets the lesion; 0
  /// where the lesion comes first.
  double along_sight = std::numeric_limits<double>::quiet_NaN();
  /// From the organ's surface to the lesion, the shortest way, and the two ends of that way.
  double shortest = std::numeric_limits<double>::quiet_NaN();
  Eigen::Vector3d surface_end = Eigen::Vector3d::Zero(), lesion_end = Eigen::Vector3d::Zero();
  /// From the marked place to the lesion's nearest point.
  double from_place = std::numeric_limits<double>::quiet_NaN();
};

/// "lesion_1_depth_along_sight_mm", "lesion_1_depth_shortest_mm", "lesion_1_from_mark_mm": those that can be
/// said.
Figures measure_figures(const LesionMeasures& measures);

/// Measures lesions in a model as it is deformed now. What it says is as good as the model's place, and no
/// better: tell the verdict with it. Not thread-safe.
class LesionMeter {
 public:
  /// @param organ its whole surface. @pre the organ has triangles.
  LesionMeter(const PatientModel& model, CarriedSurface organ, std::vector<CarriedSurface> lesions);
  ~LesionMeter();
  LesionMeter(LesionMeter&&) noexcept;
  LesionMeter& operator=(LesionMeter&&) noexcept;

  /// @param nodes_in_camera N x 3, metres. @pre one row a node of the model's mesh.
  void move(const Points& nodes_in_camera);

  /// Where a ray from the camera meets the organ first; empty: nowhere.
  std::optional<SurfacePlace> place_on(const Eigen::Vector3d& ray) const;
  /// Where it is now. @pre the place is of this organ's surface.
  Eigen::Vector3d position(const SurfacePlace& place) const;
  /// Whether a place is one of this surface: another model has other triangles.
  bool has(const SurfacePlace& place) const;
  /// A lesion without a surface of its own cannot be measured.
  LesionMeasures measure(Label lesion, const std::optional<SurfacePlace>& place = {});

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace glisson::guidance
