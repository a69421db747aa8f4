// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/common/view_state.h"

#include <algorithm>

namespace glisson::ui {

void ViewState::set_volume(std::shared_ptr<const Image> image, std::shared_ptr<const LabelMap> labels) {
  const bool other_image = image != image_;
  if (!other_image && labels == labels_) return;
  image_ = std::move(image);
  labels_ = std::move(labels);
  if (other_image && image_ && !image_->empty()) {
    const scene::VolumeBox box = scene::bounding_box(image_->grid);
    crosshair_ = Point<CtFrame>(0.5 * (box.low + box.high));
    style_.level = image_->modality == Modality::ct ? 80.0 : 300.0;
    style_.width = image_->modality == Modality::ct ? 400.0 : 600.0;
  }
  emit volume_changed();
  if (other_image) emit crosshair_changed();
}

void ViewState::set_crosshair(const Point<CtFrame>& p) {
  if (!image_ || image_->empty()) return;
  const scene::VolumeBox box = scene::bounding_box(image_->grid);
  const Eigen::Vector3d inside = p.xyz.cwiseMax(box.low).cwiseMin(box.high);
  if (inside == crosshair_.xyz) return;
  crosshair_ = Point<CtFrame>(inside);
  emit crosshair_changed();
}

void ViewState::set_window(double level, double width) {
  style_.level = std::clamp(level, -2000.0, 5000.0);
  style_.width = std::clamp(width, 1.0, 8000.0);
  emit style_changed();
}

void ViewState::set_label_opacity(double opacity) {
  style_.label_opacity = std::clamp(opacity, 0.0, 1.0);
  emit style_changed();
}

void ViewState::set_markers(std::vector<scene::Marker> markers) {
  markers_ = std::move(markers);
  emit markers_changed();
}

void ViewState::set_picking(bool on) {
  if (on == picking_) return;
  picking_ = on;
  emit picking_changed();
}

void ViewState::pick(const Point<CtFrame>& p) {
  set_crosshair(p);
  emit picked(p);
}

}  // namespace glisson::ui
