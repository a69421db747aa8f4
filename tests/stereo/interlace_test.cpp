// SPDX-License-Identifier: GPL-3.0-or-later
// Films whose even and odd rows are of two moments, and films that have as much to see and are not.
#include <QTest>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "glisson/core/files.h"
#include "glisson/stereo/faults.h"
#include "glisson/stereo/picture_io.h"
#include "picture_cv.h"

using namespace glisson;
using namespace glisson::stereo;

namespace {

constexpr int kWidth = 240, kHeight = 160, kFrames = 11;
constexpr double kTurn = 2.0 * std::numbers::pi;

/// What is seen at a pixel at a time, counted in frames; grey levels.
using Scene = std::function<double(double x, double y, double time)>;

/// Waves of 12 pixels and more in all directions.
double soft(double x, double y) {
  return 25.0 * (std::sin(kTurn * (x / 31.0 + y / 47.0)) + std::sin(kTurn * (x / 17.0 - y / 23.0) + 1.0) +
                 std::sin(kTurn * (x / 12.0 + y / 90.0) + 2.0));
}

/// Rows that are bright and dark by turns: the finest texture that there is.
double stripes(double y) { return static_cast<long>(std::floor(y)) % 2 == 0 ? 15.0 : -15.0; }

/// An instrument crosses, before fine texture that stands.
double crossed(double x, double y, double time) {
  const double from_middle = std::hypot(x - 40.0 - 6.0 * time, y - 70.0 - 2.0 * time);
  return from_middle < 45.0 ? 130.0 + soft(x - 6.0 * time, y - 2.0 * time) : 110.0 + stripes(y);
}

/// In which order a picture's fields are taken; at once.
enum class Scan { progressive, even_first, odd_first };

/// Two views, `baseline` pixels apart, with a sensor's noise.
std::vector<StereoFrame> film(const Scene& scene, Scan scan, double noise = 2.0) {
  constexpr double kBaseline = 9.0;
  std::mt19937 random(3);  // NOLINT: the same noise on every run
  std::normal_distribution<double> sensor(0.0, noise);
  std::vector<StereoFrame> frames;
  for (int i = 0; i < kFrames; ++i) {
    StereoFrame frame;
    frame.index = i;
    frame.seconds = i / 30.0;
    for (Picture* view : {&frame.left, &frame.right}) {
      auto bytes = std::make_shared<std::vector<std::uint8_t>>();
      for (int y = 0; y < kHeight; ++y) {
        const bool is_later = scan == Scan::even_first ? y % 2 == 1 : scan == Scan::odd_first && y % 2 == 0;
        for (int x = 0; x < kWidth; ++x) {
          const double level =
              scene(x + (view == &frame.right ? kBaseline : 0.0), y, i + (is_later ? 0.5 : 0.0));
          bytes->insert(bytes->end(), 3,
                        static_cast<std::uint8_t>(std::clamp(level + sensor(random), 0.0, 255.0)));
        }
      }
      *view = {kWidth, kHeight, 3, std::move(bytes)};
    }
    frames.push_back(std::move(frame));
  }
  return frames;
}

/// Read back from the recorder's video, which loses.
std::vector<StereoFrame> recorded(const std::vector<StereoFrame>& frames) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "film.mkv";
  VideoWriter writer(path, 2 * kWidth, kHeight, 30.0);
  for (const StereoFrame& frame : frames) {
    auto bytes = std::make_shared<std::vector<std::uint8_t>>();
    for (int y = 0; y < kHeight; ++y)
      for (const Picture* view : {&frame.left, &frame.right})
        bytes->insert(bytes->end(), view->bytes->begin() + 3L * kWidth * y,
                      view->bytes->begin() + 3L * kWidth * (y + 1));
    writer.write({2 * kWidth, kHeight, 3, std::move(bytes)});
  }
  writer.close();
  StereoVideo video(path);
  std::vector<StereoFrame> result;
  for (StereoFrame frame; video.read(frame);) result.push_back(frame);
  return result;
}

/// How often a film is told as interlaced.
int told(const std::vector<StereoFrame>& frames) {
  SequenceCheck check;
  int count = 0;
  for (const StereoFrame& frame : frames)
    for (const FrameFault& fault : check.push(frame)) count += fault.fault == Fault::interlaced;
  return count;
}

}  // namespace

class InterlaceTest : public QObject {
  Q_OBJECT
 private slots:
  void AnInterlacedFilmIsToldOnce() {
    for (const Scan scan : {Scan::even_first, Scan::odd_first}) {
      const auto frames = film(crossed, scan);
      QCOMPARE(told(frames), 1);
      QCOMPARE(told(recorded(frames)), 1);
    }
  }
  /// As the person is advised: one field of it is no film of two moments.
  void OfOneFieldNothingIsTold() {
    auto frames = film(crossed, Scan::even_first);
    for (StereoFrame& frame : frames)
      for (Picture* picture : {&frame.left, &frame.right})
        *picture = to_picture(one_field(view(*picture), 0));
    QCOMPARE(told(frames), 0);
  }
  void OfAProgressiveFilmNothingIsTold_data() {
    QTest::addColumn<int>("number");
    for (int n = 0; n < static_cast<int>(scenes().size()); ++n)
      QTest::newRow(scenes()[static_cast<std::size_t>(n)].first) << n;
  }
  void OfAProgressiveFilmNothingIsTold() {
    QFETCH(int, number);
    const Scene& scene = scenes()[static_cast<std::size_t>(number)].second;
    QCOMPARE(told(film(scene, Scan::progressive, 12.0)), 0);  // dark pictures, amplified
    const auto frames = film(scene, Scan::progressive);
    QCOMPARE(told(frames), 0);
    QCOMPARE(told(recorded(frames)), 0);
  }

 private:
  static const std::vector<std::pair<const char*, Scene>>& scenes() {
    static const std::vector<std::pair<const char*, Scene>> all = {
        {"an instrument crosses", crossed},
        {"nothing moves", [](double x, double y, double) { return 120.0 + soft(x, y) + stripes(y); }},
        {"fine texture moves down",
         [](double x, double y, double t) { return 120.0 + soft(x, y - t) + stripes(y - t); }},
        {"it moves down by rows and a half",
         [](double x, double y, double t) { return 120.0 + soft(x, y - 1.5 * t) + stripes(y - 1.5 * t); }},
        {"it moves across",
         [](double x, double y, double t) { return 120.0 + soft(x - 5.0 * t, y) + stripes(y); }},
        {"the picture shakes",
         [](double x, double y, double t) {
           return 120.0 + soft(x - 8.0 * std::sin(2.2 * t), y - 5.0 * std::cos(1.7 * t));
         }},
        {"the light goes on, odd rows are brighter by one", [](double x, double y, double t) {
           return 40.0 + 9.0 * t + soft(x, y) + (std::lround(y) % 2 == 1 ? 1.0 : 0.0);
         }}};
    return all;
  }
};

QTEST_APPLESS_MAIN(InterlaceTest)
#include "interlace_test.moc"
