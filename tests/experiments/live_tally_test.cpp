// SPDX-License-Identifier: GPL-3.0-or-later
// What the proof of the live overlay counts.
#include "live_tally.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <set>

#include "live_roc.h"
#include "live_run.h"

using namespace glisson;
using namespace glisson::experiments;

namespace {

JudgedFrame judged(int frame, double error, Validity validity, bool faulty) {
  JudgedFrame one;
  one.frame = frame;
  one.error = error;
  one.frozen = 2.0 * error;
  one.faulty = faulty;
  one.overlay.validity = validity;
  return one;
}

LiveFault named(const char* name) {
  LiveFault fault;
  fault.name = name;
  return fault;
}

StereoRig small_rig() {
  StereoRig rig;
  for (Camera* camera : {&rig.left, &rig.right}) {
    camera->width = 64;
    camera->height = 48;
    camera->matrix << 50.0, 0.0, 32.0, 0.0, 50.0, 24.0, 0.0, 0.0, 1.0;
  }
  rig.right_from_left.translation = {-5e-3, 0.0, 0.0};
  return rig;
}

StereoFrame plain_frame(int k) {
  StereoFrame frame;
  frame.index = k;
  frame.seconds = k / 30.0;
  for (Picture* picture : {&frame.left, &frame.right})
    *picture = {64, 48, 3,
                std::make_shared<std::vector<std::uint8_t>>(64 * 48 * 3, static_cast<std::uint8_t>(k))};
  return frame;
}

}  // namespace

class LiveTallyTest : public QObject {
  Q_OBJECT
 private slots:
  void AreaIsHowOftenAFarFrameScoresMore();
  void AScoreIsTheJudgesOwn();
  void TimesAreCountedInTheFilmsFrames();
  void AnOverlayThatWentBeforeMayStandWrongLater();
  void WhatIsBackIsRightAgain();
  void LesionsAreHeldAgainstTheirOwnErrors();
  void ThePageHoldsRocAndTheModelThatStays();
  void WhatIsMeasuredOnRealPairsIsJudged();
  void WhatDidNotHappenMeetsNoAim();
  void EveryFaultIsNamedOnceAndShowsItself();
  void WhatComesIntoEveryOperationIsNoFault();
  void AFaultThatNoStageCouldShowIsTold();
  void ThePageSaysOnWhomLimitsWereSet();
};

void LiveTallyTest::AreaIsHowOftenAFarFrameScoresMore() {
  Roc roc;
  QVERIFY(roc.empty());
  QVERIFY(std::isnan(roc.area()) && std::isnan(roc.far_hidden(1.0)) && std::isnan(roc.near_valid(1.0)));
  QVERIFY(roc.table("none").front().ends_with("area -"));
  for (const double score : {0.2, 0.4, 0.9}) roc.add(score, 1e-3, true);
  roc.add(5.0, 1e-3, false);  // near, but in a fault: neither
  roc.add(5.0, 5e-3, true);   // neither near nor far
  for (const double score : {0.4, 2.0}) roc.add(score, 20e-3, false);
  QCOMPARE(roc.area(), (1.5 + 3.0) / 6.0);
  QCOMPARE(roc.far_hidden(1.0), 0.5);
  QCOMPARE(roc.near_valid(1.0), 1.0);
  QCOMPARE(roc.near_valid(0.4), 1.0 / 3.0);
  QCOMPARE(roc.far_hidden(0.4), 1.0);
}

void LiveTallyTest::AScoreIsTheJudgesOwn() {
  JudgedFrame one = judged(1, 1e-3, Validity::valid, false);
  one.strength = 1.5;
  QCOMPARE(evidence_score(one), 0.0);  // nothing was judged yet
  one.overlay.evidence.judged = true;
  QCOMPARE(evidence_score(one), 1.5);
  one.overlay.validity = Validity::surface_apart;
  QCOMPARE(evidence_score(one), 1.5);
  one.overlay.validity = Validity::too_few_points;
  QVERIFY(std::isinf(evidence_score(one)));
}

void LiveTallyTest::TimesAreCountedInTheFilmsFrames() {
  FaultTally tally;
  std::vector<JudgedFrame> run;
  for (int k = 2; k < 60; k += 2)  // half of the frames arrive
    run.push_back(
        judged(k, k < 30 ? 1e-3 : 20e-3, k < 42 ? Validity::valid : Validity::surface_apart, k >= 30));
  tally.add(run);
  QCOMPARE(tally.latest, 12);
  QCOMPARE(tally.far, 15);
  QCOMPARE(tally.far_hidden, 9);
  QCOMPARE(tally.near_sound_valid, 14);
  QCOMPARE(tally.most_shown(), std::string("surface_apart"));
}

void LiveTallyTest::AnOverlayThatWentBeforeMayStandWrongLater() {
  const auto run_of = [](auto is_hidden) {
    std::vector<JudgedFrame> run;
    for (int k = 1; k < 60; ++k)
      run.push_back(judged(k, k < 40 ? 1e-3 : 20e-3, is_hidden(k) ? Validity::surface_apart : Validity::valid,
                           k >= 30));
    return run;
  };
  FaultTally flickered;  // while it was still right
  flickered.add(run_of([](int k) { return k == 32; }));
  QCOMPARE(flickered.latest, 20);
  FaultTally came_back;
  came_back.add(run_of([](int k) { return k >= 43 && k < 48; }));
  QCOMPARE(came_back.latest, 12);
  FaultTally went;
  went.add(run_of([](int k) { return k >= 38; }));
  QCOMPARE(went.latest, 0);
}

void LiveTallyTest::WhatIsBackIsRightAgain() {
  std::vector<JudgedFrame> run;
  for (int k = 1; k < 60; ++k)  // back at once, but right only when it has been corrected
    run.push_back(
        judged(k, k < 42 ? 8e-3 : 1e-3, k < 30 ? Validity::too_few_points : Validity::valid, false));
  FaultTally tally;
  tally.add_return(run, 30);
  QCOMPARE(tally.returned, 12);
  FaultTally never;
  never.add_return({run.begin(), run.begin() + 40}, 30);
  QCOMPARE(never.returned, 11);  // to the film's end at least
}

void LiveTallyTest::LesionsAreHeldAgainstTheirOwnErrors() {
  LesionTally tally;
  JudgedFrame one = judged(1, 20e-3, Validity::valid, false);
  const auto lesion = [&](double error, double reach, Level level, LesionReason reason) {
    LesionVerdict verdict;
    verdict.level = level;
    verdict.reason = reason;
    verdict.reach = reach;
    one.overlay.lesions.push_back(verdict);
    one.lesion_errors.push_back(error);
  };
  lesion(1e-3, 5e-3, Level::valid, LesionReason::known);
  lesion(12e-3, 15e-3, Level::degraded, LesionReason::far_from_points);
  lesion(20e-3, 5e-3, Level::valid, LesionReason::known);
  lesion(20e-3, 5e-3, Level::withdrawn, LesionReason::with_the_whole);
  tally.add(one, true);
  QCOMPARE(tally.far, 3);
  QCOMPARE(tally.far_hidden, 2);
  QCOMPARE(tally.near_sound_valid, 1);
  QCOMPARE(tally.drawn, 3);
  QCOMPARE(tally.inside, 2);
  QCOMPARE(tally.roc.far_hidden(1.0), 2.0 / 3.0);
}

void LiveTallyTest::ThePageHoldsRocAndTheModelThatStays() {
  LiveTally tally;
  std::vector<JudgedFrame> run;
  for (int k = 1; k < 60; ++k) run.push_back(judged(k, 1e-3, Validity::valid, false));
  tally.add(named("none"), run);
  LiveFault wrong = named("start");
  wrong.start_shift = {0.02, 0.0, 0.0};
  for (JudgedFrame& frame : run) frame.frozen = 1e-4;
  tally.add(wrong, run);  // from a wrong start no frozen model is one to be compared with
  LiveProof proof;
  tally.sum_up("here", "live_", proof);
  QCOMPARE(proof.figures.at("live_of_frozen_share"), 0.5);
  QCOMPARE(proof.figures.at("live_still_mean_mm"), 1.0);
  QVERIFY(proof.figures.contains("live_roc_area") && proof.figures.contains("live_frame_p99_ms"));
  QVERIFY(!proof.figures.contains("live_lesion_roc_area"));  // there were no lesions
  const auto has = [&](const char* words) {
    return std::any_of(proof.table.begin(), proof.table.end(),
                       [words](const std::string& line) { return line.find(words) != std::string::npos; });
  };
  QVERIFY(has("here, ROC of the evidence of one frame") && has("frozen"));
}

void LiveTallyTest::WhatIsMeasuredOnRealPairsIsJudged() {
  for (const char* set : {"live_tissue_", "live_heart_"})
    for (const char* key : {"far_hidden_share", "near_sound_valid_share", "latest_seconds", "scope_mean_mm",
                            "return_seconds", "of_frozen_share"})
      QVERIFY2(std::ranges::count(live_aims(), std::string(set) + key, &Aim::key) == 1, key);
}

void LiveTallyTest::WhatDidNotHappenMeetsNoAim() {
  LiveTally tally;
  std::vector<JudgedFrame> run;  // neither far nor near, and never a jump
  for (int k = 1; k < 60; ++k) run.push_back(judged(k, 5e-3, Validity::surface_apart, false));
  tally.add(named("fault"), run);
  LiveProof proof;
  tally.sum_up("here", "live_", proof);
  for (const char* key : {"live_far_hidden_share", "live_near_sound_valid_share", "live_latest_seconds",
                          "live_return_seconds", "live_of_frozen_share"}) {
    const auto aim = std::find_if(live_aims().begin(), live_aims().end(),
                                  [key](const Aim& one) { return one.key == key; });
    QVERIFY2(aim != live_aims().end(), key);
    QVERIFY2(verdict(*aim, proof.figures) == Verdict::not_measured, key);
  }
}

void LiveTallyTest::EveryFaultIsNamedOnceAndShowsItself() {
  constexpr int kOnset = 10, kFrames = 30;
  Film film;
  for (int k = 0; k < kFrames; ++k) film.push_back(plain_frame(k));
  std::set<std::string> names;
  for (const LiveFault& fault : live_faults(small_rig(), kOnset, kFrames - 1, 1)) {
    QVERIFY2(names.insert(fault.name).second, fault.name.c_str());
    const bool shows_another_film = fault.scope_moves || fault.is_lifted || fault.is_cut ||
                                    fault.other_patient || fault.scope_is_fast || fault.tool_lifts ||
                                    fault.tool_presses;
    const bool starts_elsewhere = !fault.start_turn.isIdentity() || !fault.start_shift.isZero() ||
                                  fault.start_lift != 0.0 || !fault.drift.isZero() || fault.calibration;
    QVERIFY2(fault.show || shows_another_film || starts_elsewhere || fault.name == "none",
             fault.name.c_str());
    if (!fault.show) continue;
    const StereoFrame late = fault.show(film, kFrames - 5);
    QCOMPARE(late.index, kFrames - 5);  // its own time, whatever it shows
    QCOMPARE(late.seconds, film[kFrames - 5].seconds);
  }
  for (const char* name : {"duplicated", "right_lost", "another_patient", "drift", "lifted_30mm",
                           "start_lifted_30mm", "start_across_40deg", "right_5_late_15fps"})
    QVERIFY2(names.contains(name), name);
}

void LiveTallyTest::WhatComesIntoEveryOperationIsNoFault() {
  std::set<std::string> sound;
  for (const LiveFault& fault : live_faults(small_rig(), 10, 29, 1))
    if (fault.is_sound) sound.insert(fault.name);
  QCOMPARE(sound, (std::set<std::string>{"none", "scope_moves", "scope_moves_15fps", "scope_fast",
                                         "tool_lifts", "tool_presses", "tool", "blood_ramp", "drops",
                                         "flicker", "lossy", "stutter"}));
}

void LiveTallyTest::AFaultThatNoStageCouldShowIsTold() {
  constexpr int kOnset = 10, kFrames = 30;
  LiveStage stage;
  for (int k = 0; k < kFrames; ++k) stage.standing.film.push_back(plain_frame(k));
  Untried untried;
  const auto try_all = [&] {
    for (const LiveFault& fault : live_faults(small_rig(), kOnset, kFrames - 1, 1))
      (void)untried.can_try(stage, fault);
    return untried.names();
  };
  QCOMPARE(try_all(), (std::vector<std::string>{"scope_fast", "tool_lifts", "tool_presses", "another_patient",
                                                "lifted_30mm", "cut_gapes_15mm"}));
  stage.fast = stage.tool_lifts = stage.tool_presses = stage.standing;
  QCOMPARE(try_all(), (std::vector<std::string>{"another_patient", "lifted_30mm", "cut_gapes_15mm"}));
  stage.other = stage.standing;  // of the next stage
  QCOMPARE(try_all(), (std::vector<std::string>{"lifted_30mm", "cut_gapes_15mm"}));
  stage.other = {};
  stage.lifted = stage.cut = stage.standing;
  QVERIFY(try_all().empty());
}

void LiveTallyTest::ThePageSaysOnWhomLimitsWereSet() {
  const auto says = [](const std::vector<std::uint64_t>& seeds, const char* words) {
    return QString::fromStdString(told_of_patients(seeds)).contains(QLatin1String(words));
  };
  QVERIFY(says({101}, "of seed 101") && says({101, 102}, "of seed 101, 102"));
  QVERIFY(says({101}, "limits were set on them") && says({15, 101}, "limits were set on them"));
  for (const std::uint64_t seed : {15U, 16U, 7U, 2000U}) {
    QVERIFY(!says({seed}, "limits were set on them") && says({seed}, "did not serve to set limits"));
    QCOMPARE(says({seed}, "looked at"), seed != 2000);
  }
  QVERIFY(told_of_patients({}).empty());
}

QTEST_APPLESS_MAIN(LiveTallyTest)
#include "live_tally_test.moc"
