// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "glisson/guidance/lesion_meter.h"

namespace glisson::guidance {

/// A tip that is nearer to the organ's surface than this touches it, as far as a tracked tool and a deformed
/// model can tell. Metres.
inline constexpr double kTouching = 5e-3;

/// Metres. Not a number: cannot be said.
struct ToolMeasures {
  double to_surface = std::numeric_limits<double>::quiet_NaN();  ///< of the organ, the shortest way
  bool is_inside = false;  ///< of the organ: `to_surface` is the depth below its surface
  double to_lesion = std::numeric_limits<double>::quiet_NaN();  ///< its surface, the shortest way
  std::optional<SurfacePlace> touched;                          ///< empty: the tip does not touch
};

/// Measures from the tip of a tracked tool, wherever it is, to the model as it is deformed now. As good as
/// the tool's tracking, its calibration to the camera, and the model's place. Not thread-safe.
class ToolMeter {
 public:
  /// @param organ its whole surface, closed. @pre the organ has triangles.
  ToolMeter(const PatientModel& model, CarriedSurface organ, std::vector<CarriedSurface> lesions);
  ~ToolMeter();

  /// @param nodes_in_camera N x 3, metres. @pre one row a node of the model's mesh.
  void move(const Points& nodes_in_camera);
  /// @param tip_in_camera metres. @param lesion 0: none.
  ToolMeasures measure(const Eigen::Vector3d& tip_in_camera, Label lesion) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace glisson::guidance
