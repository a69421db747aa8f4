// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/common/view_state.h"

#include <algorithm>

namespace glisson::ui {
namespace {

constexpr double kGreys = 32768.0;  ///< of a voxel, either side of none

}  // namespace

void ViewState::set_volume(std::shared_ptr<const Image> image, std::shared_ptr<const LabelMap> labels) {
  const bool other_image = image != image_;
  if (!other_image && labels == labels_) return;
  image_ = std::move(image);
  labels_ = std::move(labels);
  if (other_image && image_ && !image_->empty()) {
    const scene::VolumeBox box = scene::bounding_box(image_->grid);
    crosshair_ = Point<CtFrame>(0.5 * (box.low + box.high));
    if (!is_ct()) own_grey_ = whole_range(*image_);
    begin_window();
  }
  if (!other_image) {
    emit labels_changed();
    return;
  }
  preview_ = nullptr;
  offer_ = nullptr;
  evolving_ = nullptr;
  line_ = nullptr;
  box_.reset();
  pointer_.reset();
  measures_->wipe();       // they lie in the former image
  emit gesture_dropped();  // what a hand was drawing, too
  emit volume_changed();
  emit crosshair_changed();
}

void ViewState::set_crosshair(const Point<CtFrame>& p) {
  if (!image_ || image_->empty()) return;
  const scene::VolumeBox box = scene::bounding_box(image_->grid);
  const Eigen::Vector3d inside = p.xyz.cwiseMax(box.low).cwiseMin(box.high);
  if (inside == crosshair_.xyz) return;
  crosshair_ = Point<CtFrame>(inside);
  emit crosshair_changed();
}

void ViewState::take_window(WindowPreset preset, const GreyWindow& window) {
  preset_ = preset;
  style_.level = std::clamp(window.level, -kGreys, kGreys);
  style_.width = std::clamp(window.width, 1.0, 2.0 * kGreys);
}

void ViewState::begin_window() {
  if (is_ct())
    take_window(WindowPreset::abdomen, hounsfield_window(WindowPreset::abdomen));
  else
    take_window(WindowPreset::whole, own_grey_);
}

void ViewState::set_window(double level, double width) {
  take_window(WindowPreset::own, {level, width});
  (is_ct() ? own_ : own_grey_) = {style_.level, style_.width};
  emit style_changed();
}

void ViewState::set_own_window(const GreyWindow& window) {
  own_ = window;
  own_.width = std::max(1.0, own_.width);
}

bool ViewState::applies(WindowPreset preset) const {
  return is_hounsfield(preset) ? is_ct() : preset == WindowPreset::own || (image_ && !image_->empty());
}

void ViewState::set_preset(WindowPreset preset) {
  if (!applies(preset)) return;
  take_window(preset, preset == WindowPreset::own     ? (is_ct() ? own_ : own_grey_)
                      : preset == WindowPreset::whole ? whole_range(*image_)
                                                      : hounsfield_window(preset));
  emit style_changed();
}

void ViewState::set_label_opacity(double opacity) {
  style_.label_opacity = std::clamp(opacity, 0.0, 1.0);
  emit style_changed();
}

void ViewState::set_shows_slab(bool on) {
  if (on == shows_slab()) return;
  style_.slab = on ? slab_thickness_ : 0.0;
  emit style_changed();
}

void ViewState::set_slab_thickness(double metres) {
  slab_thickness_ = std::clamp(metres, kThinnestSlab, kThickestSlab);
  if (shows_slab()) style_.slab = slab_thickness_;
  emit style_changed();
}

void ViewState::set_markers(std::vector<scene::Marker> markers) {
  if (markers == markers_) return;
  markers_ = std::move(markers);
  emit markers_changed();
}

void ViewState::set_ellipsoids(std::vector<scene::EllipsoidMark> ellipsoids) {
  if (ellipsoids == ellipsoids_) return;
  ellipsoids_ = std::move(ellipsoids);
  emit ellipsoids_changed();
}

void ViewState::set_hidden(std::vector<Label> labels) {
  if (labels == style_.hidden) return;
  style_.hidden = std::move(labels);
  emit style_changed();
}

void ViewState::set_preview(std::shared_ptr<const LabelMap> labels) {
  if (labels == preview_) return;
  preview_ = std::move(labels);
  emit overlays_changed();
}

void ViewState::set_offer(std::shared_ptr<const engine::SegmentationOffer> offer) {
  if (offer == offer_) return;
  offer_ = std::move(offer);
  emit overlays_changed();
}

void ViewState::set_evolving(std::shared_ptr<const LabelVolume> labels) {
  if (labels == evolving_) return;
  evolving_ = std::move(labels);
  emit overlays_changed();
}

void ViewState::set_line(std::shared_ptr<const SliceLine> line) {
  if (line == line_) return;
  line_ = std::move(line);
  emit line_changed();
}

void ViewState::set_box(const std::optional<Eigen::AlignedBox3d>& box) {
  const bool same = box && box_ ? box->min() == box_->min() && box->max() == box_->max() : !box && !box_;
  if (same) return;
  box_ = box;
  emit box_changed();
}

void ViewState::set_shows_labels(bool on) {
  if (on == shows_labels_) return;
  shows_labels_ = on;
  emit shows_labels_changed();
}

void ViewState::set_hand(Hand hand) {
  if (hand == hand_) return;
  hand_ = hand;
  if (hand_ != Hand::crosshair) measures_->set_tool(MeasureTool::none);
  emit hand_changed();
}

void ViewState::set_brush(const BrushTip& brush) {
  if (brush == brush_) return;
  brush_ = brush;
  emit brush_changed();
}

void ViewState::set_pointer(const std::optional<PointerPlace>& pointer) {
  if (!pointer && !pointer_) return;
  pointer_ = pointer;
  emit pointer_changed();
}

void ViewState::pick(const Point<CtFrame>& p) {
  set_crosshair(p);
  emit picked(p);
}

}  // namespace glisson::ui
