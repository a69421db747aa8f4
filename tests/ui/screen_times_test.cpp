// SPDX-License-Identifier: GPL-3.0-or-later
// From the camera to the screen, of pictures whose times are known.
#include "glisson/ui/guidance/screen_times.h"

#include <QTest>
#include <cmath>

using glisson::ui::ScreenTimes;
using std::chrono::milliseconds;

class ScreenTimesTest : public QObject {
  Q_OBJECT
 private slots:
  void PercentilesAreThoseOfWhatWasDrawn();
  void OnlyTheLastPicturesCount();
  void TheRateIsOfTheLastTwoSeconds();
  void AnotherPlayingBeginsAnew();
};

namespace {

const ScreenTimes::Clock::time_point kStart{};

/// A picture every `period`, each `late` after it was taken.
void play(ScreenTimes& times, int first, int count, milliseconds period, milliseconds late) {
  for (int k = first; k < first + count; ++k) times.add(kStart + k * period, kStart + k * period + late);
}

bool is(const std::optional<double>& seconds, double wanted) {
  return seconds && std::abs(*seconds - wanted) < 1e-9;
}

}  // namespace

void ScreenTimesTest::PercentilesAreThoseOfWhatWasDrawn() {
  ScreenTimes times;
  QVERIFY(!times.percentile(0.5) && times.rate() == 0.0);
  for (int k = 0; k <= 100; ++k) times.add(kStart + k * milliseconds(40), kStart + k * milliseconds(41));
  QVERIFY(is(times.percentile(0.5), 0.050) && is(times.percentile(0.99), 0.099));
  QCOMPARE(times.count(), 101);
  QCOMPARE(line_of(times),
           std::string("camera to screen 50 ms median, 99 ms 99 %, 24.4 frames/s, 101 pictures"));
}

void ScreenTimesTest::OnlyTheLastPicturesCount() {
  ScreenTimes times;
  play(times, 0, 1000, milliseconds(30), milliseconds(500));
  play(times, 1000, 600, milliseconds(30), milliseconds(20));
  QVERIFY(is(times.percentile(1.0), 0.020));
  QCOMPARE(times.count(), 1600);
}

void ScreenTimesTest::TheRateIsOfTheLastTwoSeconds() {
  ScreenTimes times;
  play(times, 0, 100, milliseconds(20), milliseconds(5));
  QVERIFY(std::abs(times.rate() - 50.0) < 1e-9);
  play(times, 50, 40, milliseconds(100), milliseconds(5));  // from the fifth second on
  QVERIFY2(std::abs(times.rate() - 10.0) < 1e-9, qPrintable(QString::number(times.rate())));
}

void ScreenTimesTest::AnotherPlayingBeginsAnew() {
  ScreenTimes times;
  play(times, 0, 10, milliseconds(20), milliseconds(5));
  times.clear();
  QVERIFY(times.count() == 0 && !times.percentile(0.5) && times.rate() == 0.0);
}

QTEST_APPLESS_MAIN(ScreenTimesTest)
#include "screen_times_test.moc"
