// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/common/label_surface_source.h"

namespace glisson::ui {

LabelSurfaceSource::LabelSurfaceSource(QObject* parent)
    : QObject(parent),
      surfaces_(std::make_shared<const scene::LabelSurfaces>()),
      maker_(
          this, [this](const auto& order, const RunContext& context) { return make(order, context); },
          [this](const auto& order, const auto& made) { accept(order, made); }) {}

void LabelSurfaceSource::set_labels(std::shared_ptr<const LabelVolume> labels) {
  if (labels == wanted_) return;
  if (!labels) return forget();
  wanted_ = labels;
  making_ = true;
  maker_.give(std::move(labels));
}

void LabelSurfaceSource::forget() {
  maker_.cancel();
  wanted_.reset();
  making_ = false;
  surfaces_ = std::make_shared<const scene::LabelSurfaces>();
  emit changed();
}

void LabelSurfaceSource::accept(const std::shared_ptr<const LabelVolume>& of,
                                const std::shared_ptr<const scene::LabelSurfaces>& made) {
  // Shown even where newer labels wait: during a stroke they always do.
  surfaces_ = made;
  making_ = of != wanted_;
  emit changed();
}

Cancellable<scene::LabelSurfaces> LabelSurfaceSource::make(const std::shared_ptr<const LabelVolume>& order,
                                                           const RunContext& context) {
  auto made = scene::LabelSurfaces::of(*order, &former_, [&context] { return context.cancelled(); });
  if (made) former_ = *made;
  return made;
}

}  // namespace glisson::ui
