// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "glisson/stereo/reconstruct.h"
#include "glisson/ui/common/picture_view.h"

namespace glisson::ui {

/// The left picture, on which closed polygons are clicked. Click: next corner; click on the first corner:
/// close; Backspace: take the last corner back; Escape: give the open polygon up; drag a corner: move it;
/// right click in a polygon: remove it.
class RegionEditor : public PictureView {
  Q_OBJECT
 public:
  explicit RegionEditor(QWidget* parent = nullptr);

  /// What the next polygon will be; none: clicks do nothing but drag.
  void set_feature(std::optional<Feature> feature);
  std::optional<Feature> feature() const { return feature_; }
  void set_regions(const std::vector<stereo::Region>& regions);
  const std::vector<stereo::Region>& regions() const { return regions_; }
  const std::vector<Eigen::Vector2d>& open_polygon() const { return open_; }
  /// Dots on top, pixels of the picture: where reconstructed points are seen.
  void set_dots(std::vector<Eigen::Vector2d> dots, std::vector<Feature> features);

 signals:
  /// A polygon was closed, moved or removed.
  void regions_edited();
  /// By Esc.
  void drawing_ended();

 protected:
  void paint_over(QPainter& painter) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  struct Corner {
    std::size_t region = 0, corner = 0;
  };
  std::optional<Corner> corner_at(const QPointF& place) const;
  void remove_region_at(const QPointF& place);
  void close_region();
  void add_corner(const QPointF& place);
  QPolygonF on_screen(const std::vector<Eigen::Vector2d>& polygon) const;
  Eigen::Vector2d pixel_inside(const QPointF& place) const;

  std::optional<Feature> feature_;
  std::vector<stereo::Region> regions_;
  std::vector<Eigen::Vector2d> open_;
  std::vector<Eigen::Vector2d> dots_;
  std::vector<Feature> dot_features_;
  std::optional<Corner> dragged_;
  QPointF pointer_;
};

}  // namespace glisson::ui
