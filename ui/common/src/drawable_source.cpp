// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/common/drawable_source.h"

#include "glisson/engine/parts/model.h"

namespace glisson::ui {

DrawableSource::DrawableSource(EngineBridge& engine, QObject* parent)
    : QObject(parent),
      engine_(engine),
      maker_([this](const std::shared_ptr<const model::BuiltModel>& order, const std::stop_token&) {
        if (!order) return;
        const auto made = scene::make_drawable(std::shared_ptr<const PatientModel>(order, &order->model));
        QMetaObject::invokeMethod(
            this, [this, made] { accept(made); }, Qt::QueuedConnection);
      }) {
  connect(&engine_, &EngineBridge::case_changed, this, &DrawableSource::show_case);
  show_case();
}

void DrawableSource::show_case() {
  const auto& model = engine_.state()[part::model];
  if (model == wanted_) return;
  wanted_ = model;
  const bool had = drawable_ != nullptr;
  drawable_ = nullptr;
  maker_.give(model);
  if (had || model) emit changed();
}

void DrawableSource::accept(const std::shared_ptr<const scene::DrawableModel>& made) {
  // Another model may have come in the meantime: its own will follow.
  if (!wanted_ || made->model.get() != &wanted_->model) return;
  drawable_ = made;
  emit changed();
}

}  // namespace glisson::ui
