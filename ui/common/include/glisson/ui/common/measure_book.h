// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <QObject>
#include <optional>
#include <vector>

#include "glisson/core/frames.h"
#include "glisson/ui/scene/slice_picture.h"

namespace glisson::ui {

/// What a drag in a slice measures.
enum class MeasureTool {
  none,      ///< nothing
  distance,  ///< from place to place
  diameters  ///< one of a lesion, and another one that crosses it
};

/// A straight line in a slice; CT frame, metres.
struct MeasureLine {
  Eigen::Vector3d from = Eigen::Vector3d::Zero(), to = Eigen::Vector3d::Zero();
  double length() const { return (to - from).norm(); }
};

/// What was measured in a slice.
struct Measure {
  scene::Plane plane = scene::Plane::axial;
  MeasureTool tool = MeasureTool::distance;
  MeasureLine line{};
  std::optional<MeasureLine> across{};  ///< the second diameter
};

/// The measures of all slices, until they are wiped. Lengths are those in the patient, however the volume's
/// axes and spacing are.
class MeasureBook : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

  MeasureTool tool() const { return tool_; }
  /// Another one drops what is being drawn.
  void set_tool(MeasureTool tool);
  const std::vector<Measure>& measures() const { return measures_; }
  bool is_drawing() const { return drawing_.has_value(); }
  /// What a drag shows so far: as it will be when it ends here. Empty: nothing is drawn.
  std::optional<Measure> drawn() const;

  /// A drag. @pre a tool is chosen.
  void begin(scene::Plane plane, const Point<CtFrame>& p);
  void move(const Point<CtFrame>& p);
  /// @param least metres: what is shorter was a click and is dropped.
  void end(double least);
  void drop();
  /// Takes the last line back.
  void undo();
  void wipe();

  /// "23.4 mm"; "23.4 × 15.2 mm" with the longer one first.
  static QString text(const Measure& measure);

 signals:
  void changed();
  void tool_changed();

 private:
  /// Whether a line is the second diameter of the last measure.
  bool crosses_last(const MeasureLine& line) const;

  MeasureTool tool_ = MeasureTool::none;
  std::vector<Measure> measures_;
  scene::Plane plane_ = scene::Plane::axial;
  std::optional<MeasureLine> drawing_;
};

}  // namespace glisson::ui
