// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/segmentation/level_outline.h"

#include "glisson/ui/segmentation/edit_tools.h"

namespace glisson::ui {

LevelOutline::LevelOutline(ViewState& views, QObject* parent)
    : QObject(parent),
      views_(views),
      tracing_([this](const Order& order, const std::stop_token&) { trace(order); }) {
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
  if (traces)
    tracing_.give({image, *pointer, *label_});
  else
    views_.set_line(nullptr);
}

void LevelOutline::trace(const Order& order) {
  const VolumeGrid& grid = order.image->grid;
  const editing::TracedLevel level =
      tracer_.trace(*order.image, voxel_axis_across(grid, order.place.plane), order.place.p);
  auto line =
      std::make_shared<const SliceLine>(SliceLine{order.place, level.outline, order.label, level.open});
  QMetaObject::invokeMethod(
      this, [this, line] { accept(line); }, Qt::QueuedConnection);
}

void LevelOutline::accept(const std::shared_ptr<const SliceLine>& line) {
  // The pointer may have left, and the tool with it; another slice does not draw it.
  if (label_ == line->label && views_.pointer()) views_.set_line(line);
}

}  // namespace glisson::ui
