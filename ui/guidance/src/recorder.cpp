// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/recorder.h"

#include <algorithm>
#include <exception>
#include <utility>
#include <vector>

#include "glisson/core/error.h"
#include "glisson/core/output_file.h"
#include "glisson/patient/overlay_record.h"
#include "glisson/ui/common/error_texts.h"

namespace glisson::ui {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kMostWaiting = 8;  ///< pictures; a quarter of a second

/// Both views in one picture, the left one on the left; in colour if one of them is.
Picture side_by_side(const Picture& left, const Picture& right) {
  const int channels = std::max(left.channels, right.channels);
  auto bytes = std::make_shared<std::vector<std::uint8_t>>();
  bytes->reserve(static_cast<std::size_t>(channels) * 2 * static_cast<std::size_t>(left.width) *
                 static_cast<std::size_t>(left.height));
  for (int v = 0; v < left.height; ++v)
    for (const Picture* view : {&left, &right}) {
      const auto row = static_cast<std::ptrdiff_t>(view->channels) * view->width;
      const auto begin = view->bytes->begin() + v * row;
      if (view->channels == channels)
        bytes->insert(bytes->end(), begin, begin + row);
      else
        std::for_each(begin, begin + row, [&](std::uint8_t grey) { bytes->insert(bytes->end(), 3, grey); });
    }
  return {2 * left.width, left.height, channels, std::move(bytes)};
}

}  // namespace

/// The files of a recording; on its thread only.
class Recorder::Reel {
 public:
  explicit Reel(const RecordingOptions& options)
      : options_(options), pace_(options.frames_per_second), lines_(lines_path(options.path)) {}

  void add(const RecordedFrame& frame) {
    const stereo::FilmPace::Place place = pace_.next(frame.overlay.seconds);
    if (place.taken) return;
    if (options_.what != Recorded::raw) write(overlay_, options_.path, frame.drawn, place);
    if (options_.what != Recorded::overlay) {
      const bool alone = options_.what == Recorded::raw;
      write(raw_, alone ? options_.path : raw_path(options_.path),
            frame.right.empty() ? frame.left : side_by_side(frame.left, frame.right), place);
    }
    lines_.write(overlay_line(line_of(frame, place.number)) + "\n");
    ++pictures_;
  }

  /// @return frames. @throws Error
  int close() {
    for (auto* film : {&overlay_, &raw_}) {
      if (!*film) continue;
      (*film)->close();
      film->reset();
      is_one_whole_ = true;
    }
    return finish_lines(true);
  }
  /// Frames that show a picture once more: the next one did not come in time.
  int repeated() const { return pace_.frames() - pictures_; }
  /// What can be kept after a failure. @return frames.
  int keep() {
    int frames = is_one_whole_ ? pace_.frames() : 0;
    for (auto* film : {&overlay_, &raw_})
      if (*film) frames = std::max(frames, (*film)->keep());
    try {
      finish_lines(false);
    } catch (const Error&) {
      return frames;  // it is on a full disk: what went wrong is said already
    }
    return frames;
  }

 private:
  void write(std::optional<stereo::PacedWriter>& film, const fs::path& path, const Picture& picture,
             const stereo::FilmPace::Place& place) {
    if (!film) film.emplace(path, picture.width, picture.height, options_.frames_per_second, options_.space);
    film->add(picture, place);
  }
  OverlayLine line_of(const RecordedFrame& frame, int number) const {
    OverlayLine line;
    line.number = frame.overlay.index;
    line.overlay = frame.overlay;
    line.film_frame = number;
    line.age = frame.age;
    if (options_.remedy) line.remedy = options_.remedy(frame.overlay.validity);
    const bool is_of_model =
        frame.model && frame.overlay.nodes_in_camera.rows() == frame.model->mesh.vertex_count();
    if (frame.overlay.level() == Level::withdrawn || !is_of_model) return line;
    line.camera_from_model = pose_of(frame.model->mesh.vertices, frame.overlay);
    line.nodes_here = true;
    return line;
  }
  int finish_lines(bool whole) {
    if (pictures_ == 0) return 0;
    lines_.write(overlay_record_end(whole, pictures_) + "\n");
    lines_.commit();
    return pace_.frames();
  }

  const RecordingOptions& options_;
  stereo::FilmPace pace_;
  std::optional<stereo::PacedWriter> overlay_, raw_;
  OutputFile lines_;
  int pictures_ = 0;  ///< a line each
  bool is_one_whole_ = false;
};

fs::path Recorder::raw_path(const fs::path& path) {
  fs::path raw = path;
  return raw.replace_extension(".raw.mkv");
}

fs::path Recorder::lines_path(const fs::path& path) {
  fs::path lines = path;
  return lines.replace_extension(".frames.jsonl");
}

Recorder::Recorder(RecordingOptions options, Listener listener)
    : options_(std::move(options)), listener_(std::move(listener)), thread_([this] { run(); }) {}

Recorder::~Recorder() {
  finish();
  thread_.join();
}

void Recorder::add(RecordedFrame frame) {
  int left_out = 0;
  {
    const std::lock_guard lock(mutex_);
    if (finishing_ || failed_) return;
    if (waiting_.size() < kMostWaiting)
      waiting_.push_back(std::move(frame));
    else
      left_out = ++left_out_;
  }
  changed_.notify_one();
  if (left_out > 0 && listener_.left_out) listener_.left_out(left_out);
}

void Recorder::finish(QString why) {
  {
    const std::lock_guard lock(mutex_);
    finishing_ = true;
    if (why_.isEmpty()) why_ = std::move(why);
  }
  changed_.notify_one();
}

bool Recorder::is_done() const {
  const std::lock_guard lock(mutex_);
  return done_;
}

void Recorder::write(Reel& reel) {
  while (true) {
    RecordedFrame frame;
    {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [this] { return finishing_ || !waiting_.empty(); });
      if (waiting_.empty()) return;
      frame = std::move(waiting_.front());
      waiting_.pop_front();
    }
    reel.add(frame);
  }
}

void Recorder::run() {
  RecordingEnd end;
  end.path = QString::fromStdString(options_.path.string());
  std::optional<Reel> reel;
  try {
    reel.emplace(options_);
    write(*reel);
    end.frames = reel->close();
    end.repeated = reel->repeated();
  } catch (const std::exception& problem) {
    {
      const std::lock_guard lock(mutex_);
      failed_ = true;
      waiting_.clear();
    }
    end.error = error_text(problem.what());
    if (listener_.trouble) listener_.trouble(end.error);
    try {
      if (reel) end.frames = reel->keep();
    } catch (const std::exception&) {
      // What went wrong first is said already.
    }
  }
  {
    const std::lock_guard lock(mutex_);
    end.left_out = left_out_;
    if (end.error.isEmpty()) end.error = why_;
  }
  reel.reset();
  if (listener_.ended) listener_.ended(end);
  const std::lock_guard lock(mutex_);
  done_ = true;
}

}  // namespace glisson::ui
