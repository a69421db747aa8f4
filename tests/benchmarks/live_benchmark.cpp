// SPDX-License-Identifier: GPL-3.0-or-later
// From the frame to the screen: tracking, drawing, bringing to the screen's size and painting of each frame
// at 960x540, or another size, with 300 points a camera, one after the other, as percentiles; and beside it,
// in the same run, OpenCV's own pyramidal Lucas-Kanade of as many corners of the same pictures, there and
// back in both views. The synthetic patient, breathing before a laparoscope that a hand moves. Needs no
// display.
//   build/bench/benchmarks/live_benchmark [FRAMES [WIDTH HEIGHT]]
#include <QApplication>
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>

#include "glisson/core/error.h"
#include "glisson/core/statistics.h"
#include "glisson/experiments/synthetic_model.h"
#include "glisson/guidance/tracker.h"
#include "glisson/insilico/theatre.h"
#include "glisson/ui/guidance/live_picture.h"
#include "glisson/ui/scene/overlay_painter.h"
#include "glisson/ui/scene/picture_image.h"

namespace {

using namespace glisson;
using Clock = std::chrono::steady_clock;

constexpr int kPoints = 300;
constexpr QSize kWindow(1280, 800);

struct Film {
  PatientModel model;
  StereoRig rig;
  Points start;
  std::vector<StereoFrame> frames;
};

Film make_film(int frames, QSize size) {
  auto synthetic = experiments::synthetic_model(1, RunContext());
  Film film;
  film.model = synthetic->model;
  const PatientModel shown = experiments::shown_in_theatre(std::move(synthetic->patient));
  insilico::TheatreOptions options;
  options.frames = frames;
  options.width = size.width();
  options.height = size.height();
  const auto theatre = insilico::Theatre::build(shown, options, RunContext());
  (*theatre)->move_scope(insilico::ScopePath::in_a_hand());
  film.rig = (*theatre)->rig();
  film.start = (*theatre)->carry(film.model.mesh.vertices, 0);
  for (int k = 0; k < frames; ++k) film.frames.push_back((*theatre)->render(k));
  return film;
}

/// Milliseconds of one kind of work, frame by frame.
struct Times {
  const char* name;
  std::vector<double> values{};
  double at(double share) const {
    std::vector<double> sorted = values;
    std::sort(sorted.begin(), sorted.end());
    return interpolated_percentile(sorted, share);
  }
};

/// Adds what has passed since `from` and begins anew.
void take(Times& times, Clock::time_point& from) {
  const Clock::time_point now = Clock::now();
  times.values.push_back(std::chrono::duration<double, std::milli>(now - from).count());
  from = now;
}

/// OpenCV's own, with the tracker's window and levels.
class PlainLucasKanade {
 public:
  /// @return points that were followed.
  std::size_t follow(const StereoFrame& frame, Times& times) {
    const std::array<const Picture*, 2> views = {&frame.left, &frame.right};
    std::size_t followed = 0;
    Clock::time_point from = Clock::now();
    std::array<std::vector<cv::Mat>, 2> pyramids;
    for (std::size_t v = 0; v < 2; ++v) {
      const cv::Mat picture(views[v]->height, views[v]->width, CV_8UC3,
                            const_cast<std::uint8_t*>(views[v]->bytes->data()));
      cv::cvtColor(picture, grey_[v], cv::COLOR_BGR2GRAY);
      cv::buildOpticalFlowPyramid(grey_[v], pyramids[v], kSize, kLevels - 1, true);
      if (!corners_[v].empty()) followed += there_and_back(before_[v], pyramids[v], corners_[v]);
    }
    if (followed > 0) take(times, from);
    before_ = pyramids;
    for (std::size_t v = 0; v < 2; ++v)  // not timed: the tracker keeps its points
      cv::goodFeaturesToTrack(grey_[v], corners_[v], kPoints, 1e-3, 8.0);
    return followed;
  }

 private:
  static std::size_t there_and_back(const std::vector<cv::Mat>& from, const std::vector<cv::Mat>& next,
                                    const std::vector<cv::Point2f>& start) {
    const cv::TermCriteria stop(cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 20, 0.02);
    std::vector<cv::Point2f> to, back = start;
    std::vector<std::uint8_t> found, returned;
    std::vector<float> error;
    cv::calcOpticalFlowPyrLK(from, next, start, to, found, error, kSize, kLevels - 1, stop);
    cv::calcOpticalFlowPyrLK(next, from, to, back, returned, error, kSize, kLevels - 1, stop,
                             cv::OPTFLOW_USE_INITIAL_FLOW);
    return start.size();
  }

  static inline const cv::Size kSize{17, 17};
  static constexpr int kLevels = 3;
  std::array<cv::Mat, 2> grey_;
  std::array<std::vector<cv::Mat>, 2> before_;
  std::array<std::vector<cv::Point2f>, 2> corners_;
};

}  // namespace

int main(int argc, char** argv) {
  if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  QApplication application(argc, argv);
  const int frames = argc > 1 ? std::atoi(argv[1]) : 300;
  require(frames >= 10, "ten frames tell nothing less");
  const QSize size = argc > 3 ? QSize(std::atoi(argv[2]), std::atoi(argv[3])) : QSize(960, 540);
  const Film film = make_film(frames, size);
  Registration start;
  start.nodes_in_camera = film.start;
  guidance::TrackerOptions options;
  options.points = kPoints;
  guidance::Tracker tracker(film.model, start, options);
  tracker.begin(film.rig, film.frames[0], {});
  scene::OverlayPainter painter(film.model, film.rig.left);
  ui::LivePicture view;
  view.resize(kWindow);
  view.show();
  Times track{"tracking and mechanics"}, draw{"drawing"}, scale{"to the screen's size"}, paint{"painting"},
      all{"**frame to screen**"}, plain{"OpenCV's Lucas-Kanade"};
  PlainLucasKanade lucas_kanade;
  int valid = 0, left = 0, right = 0;
  for (std::size_t k = 1; k < film.frames.size(); ++k) {
    const StereoFrame& frame = film.frames[k];
    Clock::time_point from = Clock::now(), begin = from;
    const OverlayFrame overlay = tracker.follow(frame);
    take(track, from);
    const Picture drawn = painter.paint(frame.left, overlay);
    take(draw, from);
    const QImage ready = scene::screen_image(drawn, view.screen_size({drawn.width, drawn.height}));
    take(scale, from);
    view.set_picture(drawn, ready);
    view.repaint();
    take(paint, from);
    take(all, begin);
    lucas_kanade.follow(frame, plain);
    valid += overlay.level() == Level::valid;
    left += overlay.tracked_left;
    right += overlay.tracked_right;
  }
  const int done = static_cast<int>(film.frames.size()) - 1;
  std::printf("%d frames of %d x %d, %d with an overlay; points followed, mean: %d left, %d right\n\n", done,
              film.rig.left.width, film.rig.left.height, valid, left / done, right / done);
  std::printf("| | p50, ms | p90, ms | p99, ms | p50 over Lucas-Kanade's |\n|---|---|---|---|---|\n");
  for (const Times* times : {&track, &draw, &scale, &paint, &all, &plain})
    std::printf("| %s | %.1f | %.1f | %.1f | %.2f |\n", times->name, times->at(0.5), times->at(0.9),
                times->at(0.99), times->at(0.5) / plain.at(0.5));
  return 0;
}
