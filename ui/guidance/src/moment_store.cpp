// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/moment_store.h"

#include <sys/resource.h>
#include <unistd.h>

#include <QBuffer>
#include <QImage>

#include "glisson/ui/scene/picture_image.h"

namespace glisson::ui {
namespace {

constexpr std::size_t kMostWaiting = 4;
constexpr int kQuality = 92;  ///< of JPEG: a viewer sees no difference

}  // namespace

std::size_t MomentStore::Kept::bytes() const {
  return static_cast<std::size_t>(picture.size()) +
         static_cast<std::size_t>(overlay.nodes_in_camera.size()) * sizeof(double);
}

MomentStore::MomentStore(std::size_t bytes, QObject* parent) : QObject(parent), most_(bytes) {
  thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

MomentStore::~MomentStore() {
  thread_.request_stop();
  thread_.join();
}

void MomentStore::add(Moment moment) {
  {
    const std::lock_guard lock(mutex_);
    if (waiting_.size() >= kMostWaiting) waiting_.pop_front();
    waiting_.push_back(std::move(moment));
  }
  wanted_.notify_all();
}

void MomentStore::clear() {
  {
    const std::lock_guard lock(mutex_);
    waiting_.clear();
    kept_.clear();
    bytes_ = 0;
    ++generation_;
  }
  emit changed();
}

std::vector<MomentStore::Entry> MomentStore::entries() const {
  const std::lock_guard lock(mutex_);
  std::vector<Entry> entries;
  entries.reserve(kept_.size());
  for (const auto& [index, kept] : kept_)
    entries.push_back({index, kept.overlay.seconds, kept.overlay.level()});
  return entries;
}

std::optional<Moment> MomentStore::at(int index) const {
  Kept kept;
  {
    const std::lock_guard lock(mutex_);
    const auto found = kept_.find(index);
    if (found == kept_.end()) return {};
    kept = found->second;
  }
  const QImage image = QImage::fromData(kept.picture, "JPG");
  if (image.isNull()) return {};
  return Moment{scene::to_picture(image), std::move(kept.overlay)};
}

void MomentStore::keep(const Moment& moment, int generation) {
  Kept kept;
  kept.overlay = moment.overlay;
  QBuffer buffer(&kept.picture);
  buffer.open(QIODevice::WriteOnly);
  QImage picture = scene::view_as_image(moment.left);
  // The writer's own order of colours: any other would become four bytes a pixel first.
  if (moment.left.channels == 3) picture = picture.convertToFormat(QImage::Format_RGB888);
  if (!picture.save(&buffer, "JPG", kQuality)) return;
  {
    const std::lock_guard lock(mutex_);
    if (generation != generation_) return;
    Kept& place = kept_[moment.overlay.index];  // a video that is repeated shows a frame again
    bytes_ += kept.bytes();
    bytes_ -= place.bytes();
    place = std::move(kept);
    while (bytes_ > most_ && kept_.size() > 1) {
      bytes_ -= kept_.begin()->second.bytes();
      kept_.erase(kept_.begin());
    }
  }
  emit changed();
}

void MomentStore::run(const std::stop_token& stop) {
  constexpr int kGiveWay = 10;  // on Linux of this thread alone: what is live goes first
  ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), kGiveWay);
  while (!stop.stop_requested()) {
    Moment moment;
    int generation = 0;
    {
      std::unique_lock lock(mutex_);
      if (!wanted_.wait(lock, stop, [this] { return !waiting_.empty(); })) return;
      moment = std::move(waiting_.front());
      waiting_.pop_front();
      generation = generation_;
    }
    keep(moment, generation);
  }
}

}  // namespace glisson::ui
