// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "glisson/ui/common/picture_view.h"
#include "glisson/ui/stereo/region_drawing.h"

namespace glisson::ui {

/// One of the two pictures with what is drawn on both: passes mouse and keyboard on to the drawing, and shows
/// it, with a loupe at the pointer.
class RegionEditor : public PictureView {
  Q_OBJECT
 public:
  /// @param drawing outlives this widget.
  RegionEditor(stereo::Side side, const QString& title, RegionDrawing& drawing, QWidget* parent = nullptr);

  stereo::Side side() const { return side_; }
  /// Dots on top, pixels of the picture: where reconstructed points are seen.
  void set_dots(std::vector<Eigen::Vector2d> dots, std::vector<Feature> features);
  const std::vector<Eigen::Vector2d>& dots() const { return dots_; }
  /// An epipolar line and the point that it belongs to; empty: none.
  void set_guide(std::vector<Eigen::Vector2d> line, const std::optional<Eigen::Vector2d>& point);
  const std::vector<Eigen::Vector2d>& guide() const { return guide_; }
  /// Drawn over the picture, as large as it; null: nothing.
  void set_veil(const QImage& veil);
  bool has_veil() const { return !veil_.isNull(); }
  void set_loupe(bool on);
  /// The cursor for what a click would do now.
  void update_cursor();
  RegionDrawing::Place place_at(const QPointF& widget) const;
  /// Where the pointer is; empty: not over the picture.
  const std::optional<QPointF>& pointer() const { return pointer_; }

 signals:
  /// A region was closed, moved, removed or brought back.
  void regions_edited();
  /// Anything of the drawing, or what a click would do.
  void drawing_changed();
  /// The pointer is somewhere else, or has left.
  void pointer_moved();
  /// A click that was not part of the drawing.
  void pointed();

 protected:
  void paint_over(QPainter& painter) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void tell(bool edited);
  void paint_marks(QPainter& painter, double scale) const;
  void paint_loupe(QPainter& painter);
  void paint_region(QPainter& painter, const stereo::Region& region, bool finished, bool selected,
                    double scale) const;
  QPolygonF on_screen(const std::vector<Eigen::Vector2d>& polygon) const;
  double pixels_on_screen() const;

  stereo::Side side_;
  RegionDrawing& drawing_;
  std::vector<Eigen::Vector2d> dots_;
  std::vector<Feature> dot_features_;
  std::vector<Eigen::Vector2d> guide_;
  std::optional<Eigen::Vector2d> guide_point_;
  QImage veil_;
  bool loupe_ = true;
  std::optional<QPointF> pointer_;
};

}  // namespace glisson::ui
