// SPDX-License-Identifier: GPL-3.0-or-later
// What is judged of the surface by stereo, and alarms, repetition and options of all verdicts.
#include <QTest>

#include "alarm.h"
#include "glisson/core/error.h"
#include "glisson/guidance/tracker.h"
#include "glisson/registration/moving_surface.h"
#include "judge.h"
#include "judged_film.h"
#include "lifted_tissue.h"
#include "surface_check.h"

using namespace glisson;
using namespace glisson::guidance;

class JudgeTest : public QObject, private phantom::JudgedFilm {
  Q_OBJECT
 private slots:
  void initTestCase() { make_film(); }
  void AlarmNeedsSeveralToRiseAndMoreToGo();
  void AlarmBySecondsNeedsTwoMeasurementsAtLeast();
  void WithdrawnWithinHalfASecondAtAnyRate_data();
  void WithdrawnWithinHalfASecondAtAnyRate();
  void StereoSupportsTheTrueSurface();
  void StereoSpeaksAgainstAWrongSurface_data();
  void StereoSpeaksAgainstAWrongSurface();
  void WhatIsCoveredIsNotSupported();
  void APartThatIsLiftedIsWithdrawn_data();
  void APartThatIsLiftedIsWithdrawn();
  void AToolInFrontIsNoLiftedOrgan();
  void AToolThatHoldsTheOrganIsNoTissue();
  void TheScopeIsToldWhereItStoodBeforeTheShape();
  void WhatAMaskCoversIsNotKeptAndJudgedAllTheSame();
  void WhatLiesNearerIsTheOrganByItsBorderOrItsPoints();
  void WrongStartIsWithdrawnAndTheRightOneIsNot();
  void WhatIsSetElsewhereIsShownOnlyWhenSurfacesAgree_data();
  void WhatIsSetElsewhereIsShownOnlyWhenSurfacesAgree();
  void WhatWasRefutedStaysWithdrawnWhileNothingIsSeen_data();
  void WhatWasRefutedStaysWithdrawnWhileNothingIsSeen();
  void WhatIsSetElsewhereIsNotShownWhileNothingIsSeen();
  void WhatAgreedIsCoveredWhileNothingIsSeen();
  void WhatStaysOffIsToldFromWhatErrsOnce_data();
  void WhatStaysOffIsToldFromWhatErrsOnce();
  void VerdictsRepeat();
  void UnusableOptionsAreRefused();

 private:
  /// A part of the organ lies nearer by so much, smoothly over 20 mm.
  Points lifted(double by) const {
    Points nodes = nodes_;
    for (Eigen::Index i = 0; i < nodes.rows(); ++i) {
      const double t = std::clamp((nodes(i, 0) - nodes_.col(0).mean() - 5e-3) / 20e-3, 0.0, 1.0);
      nodes(i, 2) -= by * t * t * (3.0 - 2.0 * t);
    }
    return nodes;
  }
  /// Two seconds of plain pictures, in which stereo sees nothing, while points are still followed.
  /// @return what was said at each frame.
  std::vector<Validity> said_of_nothing(Judge& judge, const Points& nodes, double since) const {
    std::vector<Validity> said;
    StereoFrame shown;
    shown.left = phantom::plain(rig_.left, 120);
    shown.right = phantom::plain(rig_.right, 120);
    for (int k = 1; k <= 60; ++k) {
      shown.seconds = since + k / 30.0;
      OverlayFrame overlay;
      overlay.nodes_in_camera = nodes;
      said.push_back(judge.judge(shown, grid(rig_), overlay));
    }
    return said;
  }
};

void JudgeTest::AlarmNeedsSeveralToRiseAndMoreToGo() {
  Alarm alarm(2, 3);
  alarm.push(1.0, 1.0, 0.8);
  QVERIFY(!alarm.stands());
  alarm.push(0.5, 1.0, 0.8);
  alarm.push(1.2, 1.0, 0.8);
  QVERIFY(!alarm.stands());
  alarm.push(1.2, 1.0, 0.8);
  QVERIFY(alarm.stands());
  for (const double value : {0.5, 0.5, 0.9, 0.5, 0.5}) {
    alarm.push(value, 1.0, 0.8);
    QVERIFY(alarm.stands());
  }
  alarm.push(0.5, 1.0, 0.8);
  QVERIFY(!alarm.stands());
}

void JudgeTest::AlarmBySecondsNeedsTwoMeasurementsAtLeast() {
  for (const double step : {1.0 / 60.0, 1.0 / 30.0, 1.0 / 15.0, 0.2}) {
    Alarm alarm(0.1, 0.2);
    double seconds = 0.0;
    int count = 0;
    for (; !alarm.stands(); seconds += step, ++count) alarm.push(1.0, 1.0, 0.8, step);
    QVERIFY2(count >= 2 && seconds < 0.1 + std::max(step, 0.5 * 0.1) + 0.2,
             qPrintable(QString::number(count)));
    if (step < 0.05) QVERIFY(seconds > 0.099);
  }
  Alarm at_once(0.0, 0.2);
  at_once.push(0.9, 1.0, 0.8, 0.1);
  QVERIFY(!at_once.stands());
  at_once.push(1.0, 1.0, 0.8, 0.1);
  QVERIFY(at_once.stands());
}

void JudgeTest::WithdrawnWithinHalfASecondAtAnyRate_data() {
  QTest::addColumn<int>("rate");
  for (const int rate : {60, 30, 25, 15, 12, 10}) QTest::addRow("%d frames a second", rate) << rate;
}

void JudgeTest::WithdrawnWithinHalfASecondAtAnyRate() {
  QFETCH(int, rate);
  JudgeOptions options;
  options.motion = 0.0;  // the same frame over and over
  Judge judge(model_, rig_, {}, options);
  // It goes wrong just after a surface was made.
  judge.begin(first_, nodes_);
  StereoFrame shown = first_;
  int wrong = 0;
  Validity said = Validity::valid;
  for (; wrong < 2 * rate && said == Validity::valid; ++wrong) {
    shown.seconds = (wrong + 1.0) / rate;
    OverlayFrame overlay;
    overlay.nodes_in_camera = moved({0.0, 0.0, -15e-3});
    said = judge.judge(shown, grid(rig_), overlay);
  }
  QVERIFY2(said == Validity::surface_apart, validity_code(said));
  QVERIFY2(wrong <= rate / 2, qPrintable(QString("%1 frames").arg(wrong)));
}

void JudgeTest::StereoSupportsTheTrueSurface() {
  SurfaceCheck check(model_, rig_, {});
  const SurfaceEvidence evidence = check.check(first_.left, first_.right, nodes_);
  QVERIFY(evidence.predicted > 200);
  QVERIFY2(evidence.supported > 0.5, qPrintable(QString::number(evidence.supported)));
  QVERIFY2(evidence.gap < 1.5, qPrintable(QString::number(evidence.gap)));
  QVERIFY2(evidence.behind < 0.03, qPrintable(QString::number(evidence.behind)));
}

void JudgeTest::StereoSpeaksAgainstAWrongSurface_data() {
  QTest::addColumn<double>("x");
  QTest::addColumn<double>("z");
  QTest::newRow("nearer by 15 mm") << 0.0 << -15e-3;
  QTest::newRow("farther by 15 mm") << 0.0 << 15e-3;
  QTest::newRow("aside by 25 mm") << 25e-3 << 0.0;
}

void JudgeTest::StereoSpeaksAgainstAWrongSurface() {
  QFETCH(double, x);
  QFETCH(double, z);
  SurfaceCheck check(model_, rig_, {});
  const SurfaceEvidence right = check.check(first_.left, first_.right, nodes_);
  const SurfaceEvidence wrong = check.check(first_.left, first_.right, moved({x, 0.0, z}));
  QVERIFY2(wrong.supported < 0.8 * right.supported,
           qPrintable(QString("%1 after %2").arg(wrong.supported).arg(right.supported)));
  QVERIFY2(wrong.gap > 1.5 * right.gap, qPrintable(QString("%1 after %2").arg(wrong.gap).arg(right.gap)));
}

void JudgeTest::WhatIsCoveredIsNotSupported() {
  SurfaceCheck check(model_, rig_, {});
  const double open = check.check(first_.left, first_.right, nodes_).supported;
  StereoFrame covered = first_;
  for (Picture* picture : {&covered.left, &covered.right}) {
    auto bytes = std::make_shared<std::vector<std::uint8_t>>(*picture->bytes);
    for (int y = 0; y < picture->height; ++y)
      for (int x = picture->width / 2; x < picture->width; ++x)
        (*bytes)[static_cast<std::size_t>(y * picture->width + x)] = 120;
    picture->bytes = bytes;
  }
  QVERIFY(check.check(covered.left, covered.right, nodes_).supported < 0.75 * open);
}

void JudgeTest::APartThatIsLiftedIsWithdrawn_data() {
  QTest::addColumn<double>("by");
  QTest::newRow("by 10 mm") << 10e-3;
  QTest::newRow("by 30 mm") << 30e-3;
}

void JudgeTest::APartThatIsLiftedIsWithdrawn() {
  QFETCH(double, by);
  JudgeOptions options;
  options.motion = 0.0;  // the same frame over and over
  Judge judge(model_, rig_, {}, options);
  judge.begin(first_, nodes_);
  const StereoFrame shown = phantom::film(model_, lifted(by), rig_, 1);
  OverlayFrame overlay;
  Validity said = Validity::valid;
  for (int k = 1; k <= 15; ++k) {
    overlay.nodes_in_camera = nodes_;
    said = judge.judge(shown, grid(rig_), overlay);
  }
  QVERIFY2(said == Validity::surface_apart, qPrintable(QString("%1: gap %2, local %3, before %4, lifted %5")
                                                           .arg(validity_code(said))
                                                           .arg(overlay.evidence.gap)
                                                           .arg(overlay.evidence.local)
                                                           .arg(overlay.evidence.before)
                                                           .arg(overlay.evidence.lifted)));
}

void JudgeTest::AToolInFrontIsNoLiftedOrgan() {
  SurfaceCheck check(model_, rig_, {});
  const StereoFrame covered = behind_a_tool(first_);
  const SurfaceEvidence evidence = check.check(covered.left, covered.right, nodes_);
  QVERIFY2(evidence.before > 0.1, qPrintable(QString::number(evidence.before)));
  QVERIFY2(evidence.lifted < 0.5 * JudgeOptions().lifted && evidence.local < JudgeOptions().local,
           qPrintable(QString("lifted %1, local %2").arg(evidence.lifted).arg(evidence.local)));
}

void JudgeTest::AToolThatHoldsTheOrganIsNoTissue() {
  SurfaceCheck check(model_, rig_, {});
  registration::MovingSurface organ(model_);
  organ.move(nodes_);
  const auto far_from_it = [&](const SurfaceEvidence& evidence) {
    int count = 0;
    for (const Eigen::Vector3d& place : evidence.tissue)
      count += organ.closest(Feature::surface, place).distance > 10e-3;
    return count;
  };
  const SurfaceEvidence open = check.check(first_.left, first_.right, nodes_, nodes_);
  QCOMPARE(far_from_it(open), 0);
  QVERIFY(open.tissue.size() > 100);
  const double depth = nodes_.col(2).minCoeff() - 16e-3;
  const StereoFrame held = behind_a_tool(first_, 22.0, depth);
  const SurfaceEvidence evidence = check.check(held.left, held.right, nodes_, nodes_);
  QVERIFY2(evidence.before > 0.05, qPrintable(QString::number(evidence.before)));
  QVERIFY2(far_from_it(evidence) == 0, qPrintable(QString::number(far_from_it(evidence))));
  QVERIFY2(evidence.tissue.size() > 0.5 * static_cast<double>(open.tissue.size()),
           qPrintable(QString("%1 of %2").arg(evidence.tissue.size()).arg(open.tissue.size())));
}

void JudgeTest::TheScopeIsToldWhereItStoodBeforeTheShape() {
  SurfaceCheck check(model_, rig_, {});
  Rigid<CameraFrame, CameraFrame> since;  // the scope has gone on: the shape is before its former place
  since.rotation = rotation_by({0.1, -0.3, 0.2});
  since.translation = Eigen::Vector3d(0.03, -0.01, 0.02);
  const SurfaceEvidence evidence = check.check(first_.left, first_.right, nodes_, since.apply(nodes_));
  QVERIFY(evidence.tissue.size() > 100);
  QVERIFY((evidence.eye - since.translation).norm() < 1e-6);
}

void JudgeTest::WhatAMaskCoversIsNotKeptAndJudgedAllTheSame() {
  SurfaceCheck check(model_, rig_, {});
  const auto seen = [&](const Picture& not_liver) {
    return check.check(first_.left, first_.right, nodes_, nodes_, {}, not_liver);
  };
  Picture mask = phantom::plain(rig_.left, 0);
  auto bytes = std::make_shared<std::vector<std::uint8_t>>(*mask.bytes);
  for (std::size_t i = 0; i < bytes->size(); ++i)
    if (i % 320 < 160) (*bytes)[i] = 255;
  mask.bytes = bytes;
  const SurfaceEvidence open = seen({}), masked = seen(mask);
  QVERIFY(!masked.tissue.empty() && masked.tissue.size() < 0.8 * static_cast<double>(open.tissue.size()));
  for (const Eigen::Vector3d& place : masked.tissue) QVERIFY(rig_.left.project(place).x() > 150.0);
  QVERIFY(masked.supported == open.supported && masked.pull == open.pull);
}

void JudgeTest::WhatLiesNearerIsTheOrganByItsBorderOrItsPoints() {
  // 12 x 6 places at 100 mm; the right half lies nearer.
  const auto lifted = [](double by, double step, int followed) {
    SeenGrid grid{12, 6, {}, {}, {}, {}, {}};
    for (int i = 0; i < 72; ++i) {
      const int column = i % 12;
      const bool nearer = column >= 6;
      const double slope = std::clamp((column - 5) * step, 0.0, by);
      grid.range.push_back(0.1 - slope);
      grid.sigma.push_back(1e-3);
      grid.predicted.push_back(1);
      grid.nearer.push_back(nearer ? 1 : 0);
      grid.followed.push_back(nearer ? followed : 1);
    }
    int count = 0;
    for (const char place : lifted_places(grid)) count += place;
    return count;
  };
  QCOMPARE(lifted(30e-3, 5e-3, 0), 36);   // it goes over into the rest
  QCOMPARE(lifted(30e-3, 30e-3, 0), 0);   // a step, and nothing is followed there
  QCOMPARE(lifted(30e-3, 30e-3, 1), 36);  // a step, but points of the organ are there
}

void JudgeTest::WrongStartIsWithdrawnAndTheRightOneIsNot() {
  for (const double off : {0.0, -20e-3}) {
    Registration start;
    start.nodes_in_camera = moved({0.0, 0.0, off});
    start.camera_from_ct = phantom::view();
    Tracker tracker(model_, start, options());
    tracker.begin(rig_, first_, {});
    for (int k = 1; k < 4; ++k) {
      const OverlayFrame overlay = tracker.follow(frame(k));
      QVERIFY(overlay.evidence.judged || overlay.validity != Validity::valid);
      QVERIFY2((overlay.validity == Validity::valid) == (off == 0.0), validity_code(overlay.validity));
      QCOMPARE(tracker.evidence_strength() < 1.0, off == 0.0);
    }
  }
}

void JudgeTest::WhatIsSetElsewhereIsShownOnlyWhenSurfacesAgree_data() {
  QTest::addColumn<double>("off");
  QTest::newRow("where it is") << 0.0;
  QTest::newRow("nearer by 15 mm") << -15e-3;
}

void JudgeTest::WhatIsSetElsewhereIsShownOnlyWhenSurfacesAgree() {
  QFETCH(double, off);
  Judge judge(model_, rig_, {}, {});
  judge.begin(first_, nodes_);
  QVERIFY(!judge.is_undecided());
  judge.distrust();
  QVERIFY(judge.is_undecided());
  const std::vector<FollowedPoint> points = grid(rig_);
  // The first surface is of the next frame; each takes a tenth of a second. Three must agree, two refute.
  const int confirmed = 1 + 3 * 3, refuted = 1 + 2 * 3;
  for (int k = 1; k <= confirmed; ++k) {
    OverlayFrame overlay;
    overlay.nodes_in_camera = moved({0.0, 0.0, off});
    const Validity said = judge.judge(first_, points, overlay);
    const bool is_right = off == 0.0;
    QCOMPARE(said, is_right && k == confirmed ? Validity::valid : Validity::surface_apart);
    QCOMPARE(judge.is_undecided(), k < (is_right ? confirmed : refuted));
  }
}

void JudgeTest::WhatWasRefutedStaysWithdrawnWhileNothingIsSeen_data() {
  QTest::addColumn<bool>("by_mean");
  QTest::newRow("by single surfaces") << false;
  QTest::newRow("by the mean of ten") << true;
}

void JudgeTest::WhatWasRefutedStaysWithdrawnWhileNothingIsSeen() {
  QFETCH(bool, by_mean);
  JudgeOptions options;
  options.motion = 0.0;  // the same frame over and over
  if (by_mean) {
    options.gap = options.local = options.pull = 100.0;
    options.behind = options.lifted = 1.0;
  }
  Judge judge(model_, rig_, {}, options);
  const Points nodes = moved({0.0, 0.0, by_mean ? 9e-3 : -20e-3});
  judge.begin(first_, nodes);
  StereoFrame shown = first_;
  Validity said = Validity::valid;
  const int frames = by_mean ? 63 : 3;
  for (int k = 1; k <= frames; ++k) {
    shown.seconds = k / 30.0;
    OverlayFrame overlay;
    overlay.nodes_in_camera = nodes;
    said = judge.judge(shown, grid(rig_), overlay);
  }
  QCOMPARE(said, Validity::surface_apart);
  for (const Validity now : said_of_nothing(judge, nodes, shown.seconds))
    QCOMPARE(now, Validity::surface_apart);
}

void JudgeTest::WhatIsSetElsewhereIsNotShownWhileNothingIsSeen() {
  JudgeOptions options;
  options.motion = 0.0;
  Judge judge(model_, rig_, {}, options);
  judge.begin(first_, nodes_);
  judge.distrust();
  for (const Validity now : said_of_nothing(judge, nodes_, 0.0)) QCOMPARE(now, Validity::surface_apart);
  QVERIFY(!judge.is_undecided());  // it may be looked for again
}

void JudgeTest::WhatAgreedIsCoveredWhileNothingIsSeen() {
  JudgeOptions options;
  options.motion = options.contrast = 0.0;
  Judge judge(model_, rig_, {}, options);
  judge.begin(first_, nodes_);
  const std::vector<Validity> said = said_of_nothing(judge, nodes_, 0.0);
  QCOMPARE(said.front(), Validity::valid);
  QCOMPARE(said.back(), Validity::partly_covered);
  for (const Validity now : said) QVERIFY2(level_of(now) != Level::withdrawn, validity_code(now));
}

void JudgeTest::WhatStaysOffIsToldFromWhatErrsOnce_data() {
  QTest::addColumn<double>("off");
  QTest::addColumn<int>("least");  // frame in which it is told
  QTest::addColumn<int>("most");
  QTest::newRow("right") << 0.0 << -1 << -1;
  QTest::newRow("farther by 2.3 mm") << 2.3e-3 << -1 << -1;
  // 1.5 deviations in each: more than two surfaces are off by, once in a thousand, but not than five.
  QTest::newRow("farther by 3 mm") << 3e-3 << 9 << 30;
  QTest::newRow("farther by 6 mm") << 6e-3 << 6 << 6;  // the second surface: made in frame 3, compared in 6
}

void JudgeTest::WhatStaysOffIsToldFromWhatErrsOnce() {
  QFETCH(double, off);
  QFETCH(int, least);
  QFETCH(int, most);
  JudgeOptions options;
  options.gap = options.local = options.pull = 100.0;  // no single surface speaks
  options.behind = options.lifted = options.missing = 1.0;
  options.motion = options.least_supported = 0.0;
  options.unknown = 100.0;
  Judge judge(model_, rig_, {}, options);
  const Points nodes = moved({0.0, 0.0, off});
  judge.begin(first_, nodes);
  const std::vector<FollowedPoint> points = grid(rig_);
  int told = -1;
  for (int k = 1; k <= 70; ++k) {
    OverlayFrame overlay;
    overlay.nodes_in_camera = nodes;
    const Validity said = judge.judge(first_, points, overlay);
    if (said != Validity::valid && told < 0) told = k;
  }
  QVERIFY2(told >= least && told <= most, qPrintable(QString::number(told)));
}

void JudgeTest::VerdictsRepeat() {
  std::vector<double> gaps;
  for (int turn = 0; turn < 2; ++turn) {
    Registration start;
    start.nodes_in_camera = nodes_;
    Tracker tracker(model_, start, options());
    tracker.begin(rig_, first_, {});
    OverlayFrame overlay;
    for (int k = 1; k < 11; ++k) overlay = tracker.follow(frame(k));
    QVERIFY(overlay.evidence.judged);
    gaps.push_back(overlay.evidence.gap);
  }
  QCOMPARE(gaps[0], gaps[1]);
}

void JudgeTest::UnusableOptionsAreRefused() {
  const auto refused = [](auto change) {
    JudgeOptions options;
    change(options);
    QVERIFY_THROWS_EXCEPTION(InputError, options.validate());
  };
  refused([](JudgeOptions& o) { o.every = 0.0; });
  refused([](JudgeOptions& o) { o.lag = o.every; });
  refused([](JudgeOptions& o) { o.gap = 0.0; });
  refused([](JudgeOptions& o) { o.local = 0.0; });
  refused([](JudgeOptions& o) { o.lifted = 1.5; });
  refused([](JudgeOptions& o) { o.mean_gap = 0.0; });
  refused([](JudgeOptions& o) { o.behind = 1.5; });
  refused([](JudgeOptions& o) { o.pull = 0.0; });
  refused([](JudgeOptions& o) { o.pull_sigmas = 0.0; });
  refused([](JudgeOptions& o) { o.missing = -0.1; });
  refused([](JudgeOptions& o) { o.least_supported = 2.0; });
  refused([](JudgeOptions& o) { o.before = 1.5; });
  refused([](JudgeOptions& o) { o.least_signal = -1.0; });
  refused([](JudgeOptions& o) { o.contrast = 2.0; });
  refused([](JudgeOptions& o) { o.motion = -1.0; });
  refused([](JudgeOptions& o) { o.repeated = o.fresh + 0.1; });
  refused([](JudgeOptions& o) { o.fresh = 1.1; });
  refused([](JudgeOptions& o) { o.louder = 1.0; });
  refused([](JudgeOptions& o) { o.rows = 0.0; });
  refused([](JudgeOptions& o) { o.relief = 0.0; });
}

QTEST_APPLESS_MAIN(JudgeTest)
#include "judge_test.moc"
