// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/common/drawable_source.h"

namespace glisson::ui {

DrawableSource::DrawableSource(EngineBridge& engine, QObject* parent) : QObject(parent), engine_(engine) {
  thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
  connect(&engine_, &EngineBridge::case_changed, this, &DrawableSource::show_case);
  show_case();
}

DrawableSource::~DrawableSource() {
  thread_.request_stop();
  thread_.join();
}

void DrawableSource::show_case() {
  const auto& model = engine_.state().model;
  if (model == wanted_) return;
  wanted_ = model;
  const bool had = drawable_ != nullptr;
  drawable_ = nullptr;
  {
    const std::lock_guard lock(mutex_);
    order_ = model;
  }
  wake_.notify_one();
  if (had || model) emit changed();
}

void DrawableSource::accept(const std::shared_ptr<const scene::DrawableModel>& made) {
  // Another model may have come in the meantime: its own will follow.
  if (!wanted_ || made->model.get() != &wanted_->model) return;
  drawable_ = made;
  emit changed();
}

void DrawableSource::run(const std::stop_token& stop) {
  while (true) {
    std::shared_ptr<const model::BuiltModel> order;
    {
      std::unique_lock lock(mutex_);
      wake_.wait(lock, stop, [this] { return order_ != nullptr; });
      if (stop.stop_requested()) return;
      std::swap(order, order_);
    }
    const auto made = scene::make_drawable(std::shared_ptr<const PatientModel>(order, &order->model));
    QMetaObject::invokeMethod(
        this, [this, made] { accept(made); }, Qt::QueuedConnection);
  }
}

}  // namespace glisson::ui
