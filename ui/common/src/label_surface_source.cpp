// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/common/label_surface_source.h"

namespace glisson::ui {

LabelSurfaceSource::LabelSurfaceSource(QObject* parent)
    : QObject(parent),
      surfaces_(std::make_shared<const scene::LabelSurfaces>()),
      maker_([this](const auto& order, const std::stop_token& stop) { make(order, stop); }) {}

void LabelSurfaceSource::set_labels(std::shared_ptr<const LabelVolume> labels) {
  if (labels == wanted_) return;
  wanted_ = labels;
  making_ = labels != nullptr;
  if (!labels) {
    surfaces_ = std::make_shared<const scene::LabelSurfaces>();
    emit changed();
  }
  maker_.give(std::move(labels));
}

void LabelSurfaceSource::accept(const std::shared_ptr<const LabelVolume>& of,
                                const std::shared_ptr<const scene::LabelSurfaces>& made) {
  if (!wanted_) return;
  // Shown even where newer labels wait: during a stroke they always do.
  surfaces_ = made;
  making_ = of != wanted_;
  emit changed();
}

void LabelSurfaceSource::make(const std::shared_ptr<const LabelVolume>& order, const std::stop_token& stop) {
  if (!order) return;
  auto made = scene::LabelSurfaces::of(*order, former_.get(), [&stop] { return stop.stop_requested(); });
  if (!made) return;
  former_ = std::make_shared<const scene::LabelSurfaces>(std::move(*made));
  QMetaObject::invokeMethod(
      this, [this, order, surfaces = former_] { accept(order, surfaces); }, Qt::QueuedConnection);
}

}  // namespace glisson::ui
