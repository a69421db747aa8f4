// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/video_feed.h"

#include <exception>
#include <string>

#include "glisson/core/failure_sentence.h"
#include "glisson/engine/parts/video.h"
#include "glisson/stereo/picture_io.h"
#include "glisson/ui/common/error_texts.h"

namespace glisson::ui {
namespace {

constexpr std::size_t kRemembered = 120;  ///< frames

}  // namespace

VideoFeed::VideoFeed(std::function<void(StereoFrame)> sink, QObject* parent)
    : QObject(parent), sink_(std::move(sink)) {}

VideoFeed::~VideoFeed() { stop(); }

void VideoFeed::start(const engine::VideoSource& source, int first) {
  stop();
  {
    const std::lock_guard lock(mutex_);
    sent_.clear();  // this playing has the same indices, at other times
    paused_ = false;
    steps_ = 0;
  }
  thread_ = std::jthread([this, source, first](const std::stop_token& token) { play(token, source, first); });
}

void VideoFeed::stop() {
  thread_.request_stop();
  if (thread_.joinable()) thread_.join();  // at most one frame's decoding
}

void VideoFeed::pause(bool on) {
  {
    const std::lock_guard lock(mutex_);
    paused_ = on;
    steps_ = 0;
  }
  changed_.notify_all();
}

void VideoFeed::step() {
  {
    const std::lock_guard lock(mutex_);
    ++steps_;
  }
  changed_.notify_all();
}

bool VideoFeed::wait(std::unique_lock<std::mutex>& lock, const std::stop_token& stop,
                     Clock::time_point& due) {
  for (;;) {
    changed_.wait_until(lock, stop, due, [this] { return paused_; });
    if (stop.stop_requested()) return false;
    if (!paused_) return true;
    if (!changed_.wait(lock, stop, [this] { return !paused_ || steps_ > 0; })) return false;
    due = Clock::now();
    if (!paused_) continue;
    --steps_;
    return true;
  }
}

bool VideoFeed::passes_on() {
  if (!paused_) return true;
  if (steps_ == 0) return false;
  --steps_;
  return true;
}

std::optional<VideoFeed::Clock::time_point> VideoFeed::sent_at(int index) const {
  const std::lock_guard lock(mutex_);
  const auto found = sent_.find(index);
  return found == sent_.end() ? std::nullopt : std::optional(found->second);
}

void VideoFeed::play(const std::stop_token& stop, const engine::VideoSource& source, int first) {
  try {
    // A live source may keep one waiting.
    const auto cancel = std::make_shared<CancelFlag>();
    const std::stop_callback ask(stop, [cancel] { cancel->request(); });
    const auto opened = stereo::StereoVideo::open(source.left, source.right, RunContext({}, cancel, 1));
    if (!opened) return;
    stereo::StereoVideo& video = **opened;
    const double rate = video.frames_per_second() > 0.0 ? video.frames_per_second() : 30.0;
    rate_ = rate;
    StereoFrame frame;
    // What is live counts from this opening: none of its frames lies before `first`, each is of now.
    for (int skipped = 0; !video.is_live() && skipped < first && !stop.stop_requested(); ++skipped)
      if (!video.read(frame)) break;
    Clock::time_point due = Clock::now();
    while (!stop.stop_requested() && video.read(frame)) {
      const Clock::time_point came = Clock::now();
      std::unique_lock lock(mutex_);
      // What is live has its own rate, and ages from when it came: nothing of it is held back.
      if (video.is_live() && !passes_on()) continue;
      if (!video.is_live() && !wait(lock, stop, due)) return;
      sent_[frame.index] = video.is_live() ? came : Clock::now();
      while (sent_.size() > kRemembered) sent_.erase(sent_.begin());
      lock.unlock();
      sink_(frame);
      const auto period =
          std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(1.0 / (rate * speed_)));
      due = std::max(due + period, Clock::now() - period);  // a slow disk does not cause a burst
    }
    if (!stop.stop_requested()) emit ended();
  } catch (const std::exception& error) {  // one of a library would end the program, too
    emit failed(error_text(sentence_of(error, "video")));
  }
}

}  // namespace glisson::ui
