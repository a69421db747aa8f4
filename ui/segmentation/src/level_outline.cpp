// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/segmentation/level_outline.h"

#include "glisson/ui/segmentation/edit_tools.h"

namespace glisson::ui {

LevelOutline::LevelOutline(ViewState& views, QObject* parent)
    : QObject(parent),
      views_(views),
      tracing_(
          this, [this](const Order& order, const RunContext&) { return trace(order); },
          [this](const Order&, const std::shared_ptr<const SliceLine>& line) { accept(line); }) {
  for (const auto signal : {&ViewState::pointer_changed, &ViewState::crosshair_changed})
    connect(&views_, signal, this, &LevelOutline::follow);
}

void LevelOutline::set_label(const std::optional<Label>& label) {
  if (label == label_) return;
  label_ = label;
  follow();
}

void LevelOutline::follow() {
  const auto& image = views_.image();
  const auto& pointer = views_.pointer();
  const bool traces = label_ && pointer && image && scene::probe(*image, nullptr, pointer->p).inside;
  if (traces) {
    tracing_.give({image, *pointer, *label_});
  } else {
    tracing_.cancel();
    if (draws_) views_.set_line(nullptr);
    draws_ = false;
  }
}

SliceLine LevelOutline::trace(const Order& order) {
  const VolumeGrid& grid = order.image->grid;
  const editing::TracedLevel level =
      tracer_.trace(*order.image, voxel_axis_across(grid, order.place.plane), order.place.p);
  return {order.place, level.outline, order.label, level.open};
}

void LevelOutline::accept(const std::shared_ptr<const SliceLine>& line) {
  // The pointer may have left, and the tool with it; another slice does not draw it.
  if (label_ != line->label || !views_.pointer()) return;
  draws_ = true;
  views_.set_line(line);
}

}  // namespace glisson::ui
