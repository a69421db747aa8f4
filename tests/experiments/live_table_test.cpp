// SPDX-License-Identifier: GPL-3.0-or-later
// The manual's table "When something goes wrong": what is shown, and from which frame on.
#include <QTest>
#include <algorithm>

#include "known_pair.h"
#include "live_run.h"
#include "moved_tissue.h"

using namespace glisson;
using namespace glisson::experiments;

namespace {

constexpr int kFrames = 60, kOnset = 30;
constexpr int kSoon = 15;  ///< frames: half a second, in which whatever is over 10 mm off is to go

/// Twice as long: from its end it goes back.
void go_back(Filmed& filmed) {
  const auto n = static_cast<int>(filmed.film.size());
  for (int k = n - 2; k >= 0; --k) {
    StereoFrame frame = filmed.film[static_cast<std::size_t>(k)];
    frame.index = 2 * (n - 1) - k;
    frame.seconds = frame.index / 30.0;
    filmed.film.push_back(frame);
    filmed.targets.push_back(Points(filmed.targets[static_cast<std::size_t>(k)]));
  }
}

/// The longest run of valid frames that are over 10 mm off.
int longest_wrong(const std::vector<JudgedFrame>& run) {
  int longest = 0, now = 0;
  for (const JudgedFrame& judged : run) {
    now = judged.is_valid() && judged.error > 10e-3 ? now + 1 : 0;
    longest = std::max(longest, now);
  }
  return longest;
}

}  // namespace

class LiveTableTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void AFaultIsShownAsTheManualSays_data();
  void AFaultIsShownAsTheManualSays();
  void ASlowDriftIsToldBeforeItIsTenMillimetres();

 private:
  static std::vector<JudgedFrame> run_of(const LiveStage& stage, const std::string& name) {
    const int last = static_cast<int>(stage.standing.film.size()) - 1;
    const auto faults = live_faults(stage.rig, kOnset, last, 1);
    return run_live(stage, *std::ranges::find(faults, name, &LiveFault::name), kOnset);
  }
  LiveStage stage_;
};

void LiveTableTest::initTestCase() {
  auto stage = pair_stage(test::known_pair().pair, kFrames, 1, RunContext());
  auto other = pair_stage(test::known_pair(5).pair, kFrames / 2 + 1, 2, RunContext());
  QVERIFY(stage && other);
  stage_ = std::move(*stage);
  stage_.other = std::move(other->standing);
  go_back(stage_.other);
}

void LiveTableTest::AFaultIsShownAsTheManualSays_data() {
  QTest::addColumn<int>("from");    // frame in which it begins
  QTest::addColumn<int>("within");  // frames until it is told; -1: an overlay that is right stays
  const auto row = [](const char* fault, int from, int within) { QTest::newRow(fault) << from << within; };
  row("none", 0, -1);
  row("duplicated", 0, -1);
  row("flicker", 0, -1);
  for (const char* start :
       {"start_x_10mm", "start_x_20mm", "start_x_40mm", "start_z_10mm", "start_view_40deg",
        "start_view_180deg", "start_across_20deg", "start_across_40deg", "start_lifted_30mm", "mirrored",
        "another_patient", "focal_85", "baseline_120", "centre_20px"})
    row(start, 0, 1);
  row("frozen", kOnset, 12);
  row("frozen_noise", kOnset, 12);
  row("right_frozen", kOnset, 5);
  row("right_5_late", kOnset, 3);
  row("right_lost", kOnset, 1);
  row("swapped", kOnset, 1);
  row("black", kOnset, 1);
  row("blur", kOnset, 1);
  row("lifted_30mm", kFrames / 2, 20);
  row("cut_gapes_15mm", kFrames / 2, kFrames / 2 - 1);
}

void LiveTableTest::AFaultIsShownAsTheManualSays() {
  QFETCH(int, from);
  QFETCH(int, within);
  const auto run = run_of(stage_, QTest::currentDataTag());
  const auto told = [](const JudgedFrame& judged) {
    return qPrintable(QString("frame %1: %2, %3 mm")
                          .arg(judged.frame)
                          .arg(QLatin1String(validity_code(judged.overlay.validity)))
                          .arg(1e3 * judged.error));
  };
  for (const JudgedFrame& judged : run) {
    if (within < 0 || judged.frame < from) QVERIFY2(judged.is_valid() && judged.error < 3e-3, told(judged));
    if (within >= 0 && judged.frame >= from + within)
      QVERIFY2(judged.overlay.level() == Level::withdrawn, told(judged));
  }
  QVERIFY2(longest_wrong(run) <= kSoon, qPrintable(QString::number(longest_wrong(run))));
}

void LiveTableTest::ASlowDriftIsToldBeforeItIsTenMillimetres() {
  LiveStage longer = stage_;
  go_back(longer.standing);
  const auto run = run_of(longer, "drift");
  QVERIFY(run.front().is_valid() && run.back().error > 10e-3);
  QCOMPARE(longest_wrong(run), 0);
}

QTEST_GUILESS_MAIN(LiveTableTest)
#include "live_table_test.moc"
