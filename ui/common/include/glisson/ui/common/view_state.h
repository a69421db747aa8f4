// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>
#include <vector>

#include "glisson/patient/label_map.h"
#include "glisson/ui/scene/patient_scene.h"
#include "glisson/ui/scene/slice_picture.h"
#include "glisson/volume/image.h"

namespace glisson::ui {

/// What the linked views share: the volume, the crosshair, the grey window, the markers and what a click
/// means.
class ViewState : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

  const std::shared_ptr<const Image>& image() const { return image_; }
  const std::shared_ptr<const LabelMap>& labels() const { return labels_; }
  /// Another image puts the crosshair in its middle.
  void set_volume(std::shared_ptr<const Image> image, std::shared_ptr<const LabelMap> labels);

  const Point<CtFrame>& crosshair() const { return crosshair_; }
  /// Kept inside the volume.
  void set_crosshair(const Point<CtFrame>& p);

  const scene::SliceStyle& style() const { return style_; }
  void set_window(double level, double width);
  void set_label_opacity(double opacity);

  const std::vector<scene::Marker>& markers() const { return markers_; }
  void set_markers(std::vector<scene::Marker> markers);

  /// While picking, a click in a slice places a point instead of moving the crosshair only.
  bool picking() const { return picking_; }
  void set_picking(bool on);
  /// Called by the views.
  void pick(const Point<CtFrame>& p);

 signals:
  void volume_changed();
  void crosshair_changed();
  void style_changed();
  void markers_changed();
  void picking_changed();
  void picked(const glisson::Point<glisson::CtFrame>& p);

 private:
  std::shared_ptr<const Image> image_;
  std::shared_ptr<const LabelMap> labels_;
  Point<CtFrame> crosshair_;
  scene::SliceStyle style_;
  std::vector<scene::Marker> markers_;
  bool picking_ = false;
};

}  // namespace glisson::ui
