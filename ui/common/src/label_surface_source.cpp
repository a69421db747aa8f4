// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/common/label_surface_source.h"

namespace glisson::ui {

LabelSurfaceSource::LabelSurfaceSource(QObject* parent)
    : QObject(parent), surfaces_(std::make_shared<const scene::LabelSurfaces>()) {
  thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

LabelSurfaceSource::~LabelSurfaceSource() {
  thread_.request_stop();
  thread_.join();
}

void LabelSurfaceSource::set_labels(std::shared_ptr<const LabelVolume> labels) {
  if (labels == wanted_) return;
  wanted_ = labels;
  making_ = labels != nullptr;
  if (!labels) {
    surfaces_ = std::make_shared<const scene::LabelSurfaces>();
    emit changed();
  }
  {
    const std::lock_guard lock(mutex_);
    order_ = std::move(labels);
  }
  wake_.notify_one();
}

void LabelSurfaceSource::accept(const std::shared_ptr<const LabelVolume>& of,
                                const std::shared_ptr<const scene::LabelSurfaces>& made) {
  if (!wanted_) return;
  // During a stroke newer labels always wait: what was made meanwhile is shown all the same.
  surfaces_ = made;
  making_ = of != wanted_;
  emit changed();
}

void LabelSurfaceSource::run(const std::stop_token& stop) {
  std::shared_ptr<const scene::LabelSurfaces> former;  // even of other labels: it compares bricks
  while (true) {
    std::shared_ptr<const LabelVolume> order;
    {
      std::unique_lock lock(mutex_);
      wake_.wait(lock, stop, [this] { return order_ != nullptr; });
      if (stop.stop_requested()) return;
      std::swap(order, order_);
    }
    auto made = scene::LabelSurfaces::of(*order, former.get(), [&stop] { return stop.stop_requested(); });
    if (!made) return;
    former = std::make_shared<const scene::LabelSurfaces>(std::move(*made));
    QMetaObject::invokeMethod(
        this, [this, order, former] { accept(order, former); }, Qt::QueuedConnection);
  }
}

}  // namespace glisson::ui
