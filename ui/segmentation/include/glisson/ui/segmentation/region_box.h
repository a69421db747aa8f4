// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <array>
#include <optional>

#include "glisson/ui/common/view_state.h"
#include "glisson/ui/segmentation/box_drag.h"

class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace glisson::ui {

/// Where growth may change labels, and how finely it works: a box that is drawn on the slices or typed, and
/// the resolution.
class RegionBox : public QWidget {
  Q_OBJECT
 public:
  explicit RegionBox(ViewState& views, QWidget* parent = nullptr);

  /// CT frame, metres, along LPS; none: the whole volume.
  const std::optional<Eigen::AlignedBox3d>& region() const { return region_; }
  void set_region(const std::optional<Eigen::AlignedBox3d>& region);
  double resolution_mm() const;

  /// The box is drawn in the views, or not.
  void set_active(bool on);
  /// Drags in the slices draw the box, or move its edges; otherwise they are somebody else's.
  void set_drawing(bool on);
  bool is_drawing() const { return drawing_; }
  /// Drops a drag that has begun, else ends drawing. @return whether there was one of them.
  bool escape();

 signals:
  void drawing_started();
  void changed();

 private:
  void build_bounds();
  void build_resolution();
  void hear(const SliceGesture& gesture);
  void show_volume();
  void show_region();
  void show_size();
  void take_bounds();
  Eigen::AlignedBox3d volume_box() const;

  ViewState& views_;
  std::optional<Eigen::AlignedBox3d> region_;
  std::optional<BoxDrag> drag_;
  bool active_ = false, drawing_ = false;
  QPushButton* draw_ = nullptr;
  QPushButton* clear_ = nullptr;
  QWidget* bounds_ = nullptr;
  std::array<std::array<QDoubleSpinBox*, 2>, 3> sides_{};  ///< of each axis: low, high; mm
  QDoubleSpinBox* resolution_ = nullptr;
  QPushButton* own_ = nullptr;
  QLabel* size_ = nullptr;
};

}  // namespace glisson::ui
