// SPDX-License-Identifier: GPL-3.0-or-later
// Evidence that is not the tracker's own, and the verdicts on overlays.
#include <QtTest>

#include "alarm.h"
#include "filmed_phantom.h"
#include "glisson/core/error.h"
#include "glisson/guidance/tracker.h"
#include "judge.h"
#include "lifted_tissue.h"
#include "motion_check.h"
#include "picture_check.h"
#include "surface_check.h"

using namespace glisson;
using namespace glisson::guidance;

class JudgeTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void AlarmNeedsSeveralToRiseAndMoreToGo();
  void AlarmBySecondsNeedsTwoMeasurementsAtLeast();
  void WithdrawnWithinHalfASecondAtAnyRate_data();
  void WithdrawnWithinHalfASecondAtAnyRate();
  void SmokeAndDarknessLoseSignalAndNoiseIsNone();
  void RowsStayWithBothViewsOfOneMoment();
  void WhatIsWrongFromTheFirstIsNoNorm();
  void NoiseIsNoMotionAndBreathIs_data();
  void NoiseIsNoMotionAndBreathIs();
  void StereoSupportsTheTrueSurface();
  void StereoSpeaksAgainstAWrongSurface_data();
  void StereoSpeaksAgainstAWrongSurface();
  void WhatIsCoveredIsNotSupported();
  void APartThatIsLiftedIsWithdrawn_data();
  void APartThatIsLiftedIsWithdrawn();
  void AToolInFrontIsNoLiftedOrgan();
  void WhatLiesNearerIsTheOrganByItsBorderOrItsPoints();
  void WrongStartIsWithdrawnAndTheRightOneIsNot();
  void StandingPictureIsWithdrawn();
  void AStillPictureIsToldFromACopy_data();
  void AStillPictureIsToldFromACopy();
  void WhatIsSetElsewhereIsShownOnlyWhenSurfacesAgree_data();
  void WhatIsSetElsewhereIsShownOnlyWhenSurfacesAgree();
  void WhatStaysOffIsToldFromWhatErrsOnce_data();
  void WhatStaysOffIsToldFromWhatErrsOnce();
  void VerdictsRepeat();
  void UnusableOptionsAreRefused();

 private:
  static TrackerOptions options() { return phantom::free_body(); }
  Points moved(const Eigen::Vector3d& by) const { return nodes_.rowwise() + by.transpose(); }
  /// A film of the body moving down by half a millimetre a frame.
  StereoFrame frame(int k) const {
    return phantom::film(model_, moved({0.0, 0.5e-3 * k, -0.2e-3 * k}), rig_, k);
  }
  /// A part of the organ lies nearer by so much, smoothly over 20 mm.
  Points lifted(double by) const {
    Points nodes = nodes_;
    for (Eigen::Index i = 0; i < nodes.rows(); ++i) {
      const double t = std::clamp((nodes(i, 0) - nodes_.col(0).mean() - 5e-3) / 20e-3, 0.0, 1.0);
      nodes(i, 2) -= by * t * t * (3.0 - 2.0 * t);
    }
    return nodes;
  }
  /// Something flat and textured before the organ, 60 mm before the lens. @param half pixels of its width.
  StereoFrame behind_a_tool(const StereoFrame& frame, double half = 22.0) const {
    StereoFrame covered = frame;
    for (Picture* picture : {&covered.left, &covered.right}) {
      auto bytes = std::make_shared<std::vector<std::uint8_t>>(*picture->bytes);
      // The cameras turn towards each other by 0.02, so what is far is shifted, too.
      const double shift = picture == &covered.left ? 0.0 : 260.0 * (5e-3 / 60e-3 - 0.02);
      for (int y = 0; y < picture->height; ++y)
        for (int x = 0; x < picture->width; ++x)
          if (const double u = x + shift, across = u - 190.0 + 0.3 * (y - 120.0); std::abs(across) < half)
            (*bytes)[static_cast<std::size_t>(y * picture->width + x)] = static_cast<std::uint8_t>(
                60.0 + 150.0 * phantom::value_noise(Eigen::Vector3d(u / 7.0, y / 7.0, 0.5)));
      picture->bytes = bytes;
    }
    return covered;
  }
  static std::vector<FollowedPoint> grid(const StereoRig& rig) {
    std::vector<FollowedPoint> points;
    for (int i = 0; i < 200; ++i) {
      FollowedPoint point;
      point.id = i;
      point.p_in_camera = {0.004 * (i % 20 - 10), 0.006 * (i / 20 - 5), 0.12};
      point.left = rig.left.project(point.p_in_camera);
      point.right = rig.right.project(rig.right_from_left.rotation * point.p_in_camera +
                                      rig.right_from_left.translation);
      points.push_back(point);
    }
    return points;
  }

  StereoRig rig_ = phantom::rig();
  PatientModel model_ = phantom::model(8, 6, 3);
  Points nodes_;
  StereoFrame first_;
};

void JudgeTest::initTestCase() {
  nodes_ = phantom::view().apply(model_.mesh.vertices);
  first_ = phantom::film(model_, nodes_, rig_, 0);
}

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

void JudgeTest::SmokeAndDarknessLoseSignalAndNoiseIsNone() {
  const auto changed = [&](double gain, double offset, double noise) {
    std::mt19937 random(5);
    std::normal_distribution<double> normal(0.0, noise);
    auto bytes = std::make_shared<std::vector<std::uint8_t>>(*first_.left.bytes);
    for (auto& byte : *bytes)
      byte = static_cast<std::uint8_t>(std::clamp(gain * byte + offset + normal(random), 0.0, 240.0));
    Picture picture = first_.left;
    picture.bytes = bytes;
    return measure(picture);
  };
  const double clear = changed(1.0, 0.0, 2.0).signal();
  QVERIFY(clear > 1.0);
  QVERIFY(changed(0.4, 120.0, 2.0).signal() < 0.6 * clear);
  QVERIFY(changed(0.15, 0.0, 2.0).signal() < 0.4 * clear);
  QVERIFY(changed(0.0, 100.0, 4.0).signal() < 0.2);
  QVERIFY(std::abs(changed(0.0, 100.0, 4.0).noise - 4.0) < 0.5);
}

void JudgeTest::RowsStayWithBothViewsOfOneMoment() {
  MotionCheck check;
  std::vector<FollowedPoint> now = grid(rig_);
  for (int k = 0; k < 8; ++k) check.push(now, rig_, k / 30.0);
  QVERIFY(std::abs(check.rows()) < 1e-6);
  for (FollowedPoint& point : now) point.right.y() += 0.5;  // the right view shows another moment
  check.push(now, rig_, 8 / 30.0);
  QVERIFY2(std::abs(std::abs(check.rows()) - 0.5) < 0.05, qPrintable(QString::number(check.rows())));
}

void JudgeTest::WhatIsWrongFromTheFirstIsNoNorm() {
  MotionCheck check;
  std::vector<FollowedPoint> now = grid(rig_);
  for (std::size_t i = 0; i < now.size(); ++i) now[i].right.y() += i % 2 == 0 ? 1.2 : 2.8;
  for (int k = 0; k < 8; ++k) check.push(now, rig_, k / 30.0);
  const double limit = std::max(JudgeOptions().rows, check.rows_scatter());
  QVERIFY2(std::abs(check.rows()) > limit, qPrintable(QString("%1 of %2").arg(check.rows()).arg(limit)));

  StereoFrame dull = first_;
  for (Picture* picture : {&dull.left, &dull.right}) {
    auto bytes = std::make_shared<std::vector<std::uint8_t>>(*picture->bytes);
    for (auto& byte : *bytes) byte = static_cast<std::uint8_t>(150 + 0.004 * byte);
    picture->bytes = bytes;
  }
  for (const auto& [first, said] : {std::pair{dull, Validity::poor_picture},
                                    std::pair{behind_a_tool(first_, 110.0), Validity::partly_covered}}) {
    JudgeOptions options;
    options.supported = options.least_supported = 0.0;  // what is seen less is another reason
    options.unknown = options.gap = options.local = options.pull = 100.0;
    options.behind = options.lifted = 1.0;
    options.before = 0.3;
    Judge judge(model_, rig_, {}, options);
    judge.begin(first, nodes_);
    OverlayFrame overlay;
    overlay.nodes_in_camera = nodes_;
    const Validity found = judge.judge(first, grid(rig_), overlay);
    QVERIFY2(found == said, qPrintable(QString("%1, before %2, contrast %3")
                                           .arg(validity_code(found))
                                           .arg(overlay.evidence.before)
                                           .arg(overlay.evidence.contrast)));
  }
}

void JudgeTest::NoiseIsNoMotionAndBreathIs_data() {
  QTest::addColumn<QString>("way");
  QTest::addColumn<bool>("moves");
  QTest::addColumn<int>("rate");   // frames a second
  QTest::addColumn<int>("first");  // frame that can be judged
  for (const auto& [rate, first] : {std::pair{30, 11}, {60, 22}, {25, 9}, {12, 4}, {5, 3}}) {
    const auto row = [&, rate = rate, first = first](const char* name, const char* way, bool moves) {
      QTest::addRow("%s, %d frames a second", name, rate) << way << moves << rate << first;
    };
    row("still, each picture with its own noise", "still", false);
    row("still, points that slip", "slip", false);
    row("breath", "breath", true);
    row("breath that turns", "turn", true);
    row("still, one point that moves", "one", false);
  }
}

void JudgeTest::NoiseIsNoMotionAndBreathIs() {
  QFETCH(QString, way);
  QFETCH(bool, moves);
  QFETCH(int, rate);
  QFETCH(int, first);
  std::mt19937 random(9);
  std::normal_distribution<double> noise(0.0, 0.05);
  MotionCheck check;
  const std::vector<FollowedPoint> start = grid(rig_);
  std::vector<FollowedPoint> now = start;
  for (int k = 0; k <= first + 2; ++k) {
    const double frame = 30.0 * k / rate;  // in thirtieths of a second
    // Four pixels of breath in four seconds, at half way and at its end.
    const double along = way == "breath" ? 0.1 * frame
                         : way == "turn" ? 2.0 - 2.0 * std::cos(0.052 * (frame - 7.0))
                                         : 0.0;
    for (std::size_t i = 0; i < now.size(); ++i) {
      const FollowedPoint& from = way == "slip" ? now[i] : start[i];
      const double down = along + (way == "one" && i == 20 ? 0.3 * frame : 0.0);
      now[i].left = from.left + Eigen::Vector2d(noise(random), noise(random) + down);
      now[i].right = from.right + Eigen::Vector2d(noise(random), noise(random) + down);
    }
    check.push(now, rig_, frame / 30.0);
    QCOMPARE(check.motion_left() < 0.0, k < first);
  }
  const double limit = JudgeOptions().motion, left = check.motion_left(), right = check.motion_right();
  const QByteArray found = QByteArray::number(left) + " and " + QByteArray::number(right);
  if (moves)
    QVERIFY2(left > limit && right > limit, found);
  else
    QVERIFY2(left > 0.4 && left < 0.7 * limit && right > 0.4 && right < 0.7 * limit, found);
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
    }
  }
}

void JudgeTest::StandingPictureIsWithdrawn() {
  Registration start;
  start.nodes_in_camera = nodes_;
  Tracker tracker(model_, start, options());
  tracker.begin(rig_, first_, {});
  OverlayFrame overlay;
  for (int k = 1; k < 15; ++k) overlay = tracker.follow(first_);
  QVERIFY2(overlay.validity == Validity::picture_stands, validity_code(overlay.validity));
}

void JudgeTest::AStillPictureIsToldFromACopy_data() {
  QTest::addColumn<QString>("shown");
  QTest::addColumn<int>("said");
  const auto row = [](const char* name, const char* shown, Validity said) {
    QTest::newRow(name) << shown << static_cast<int>(said);
  };
  row("breath held, alive", "alive", Validity::valid);
  row("breath held from the first frame on", "alive from the first", Validity::picture_still);
  row("breath held, smoothed in time by a codec", "smoothed", Validity::picture_still);
  row("one moment again and again", "copies", Validity::picture_stands);
  row("copies with noise", "noisy copies", Validity::picture_stands);
  row("copies with loud noise", "loud copies", Validity::picture_stands);
}

void JudgeTest::AStillPictureIsToldFromACopy() {
  QFETCH(QString, shown);
  QFETCH(int, said);
  Registration start;
  start.nodes_in_camera = nodes_;
  Tracker tracker(model_, start, options());
  tracker.begin(rig_, first_, {});
  constexpr int kStill = 14;  // it moves until then
  const int from = shown == "alive from the first" ? 0 : kStill;
  std::vector<StereoFrame> alive;  // one place, noise of its own in each
  for (int k = 0; k < 4; ++k) {
    alive.push_back(phantom::film(model_, moved({0.0, 0.5e-3 * from, -0.2e-3 * from}), rig_, from + k));
  }
  const auto noisy = [](const Picture& picture, double share, const Picture& other, double noise,
                        unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal(0.0, std::max(noise, 1e-9));
    Picture result = picture;
    auto bytes = std::make_shared<std::vector<std::uint8_t>>(*picture.bytes);
    for (std::size_t i = 0; i < bytes->size(); ++i)
      (*bytes)[i] = static_cast<std::uint8_t>(std::clamp(
          std::round((1.0 - share) * (*bytes)[i] + share * (*other.bytes)[i] + normal(random)), 0.0, 255.0));
    result.bytes = bytes;
    return result;
  };
  OverlayFrame overlay;
  for (int k = 1; k < from + 16; ++k) {
    StereoFrame now = k < from ? frame(k) : alive[0];
    const StereoFrame& next = alive[static_cast<std::size_t>(k % 4)];
    if (k >= from && shown.startsWith("alive")) now = next;
    for (Picture StereoFrame::*view : {&StereoFrame::left, &StereoFrame::right}) {
      if (k < from) break;
      const auto seed = static_cast<unsigned>(2 * k + (view == &StereoFrame::left ? 0 : 1));
      if (shown == "smoothed") now.*view = noisy(now.*view, 0.5, next.*view, 0.0, seed);
      if (shown == "noisy copies") now.*view = noisy(now.*view, 0.0, now.*view, 1.5, seed);
      if (shown == "loud copies") now.*view = noisy(now.*view, 0.0, now.*view, 4.0, seed);
    }
    now.index = k;
    now.seconds = k / 30.0;
    overlay = tracker.follow(now);
    if (k < from) QVERIFY2(overlay.validity == Validity::valid, validity_code(overlay.validity));
  }
  QVERIFY2(overlay.validity == static_cast<Validity>(said),
           qPrintable(QString("%1, motion %2, fresh %3")
                          .arg(validity_code(overlay.validity))
                          .arg(overlay.evidence.motion)
                          .arg(overlay.evidence.fresh)));
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

void JudgeTest::WhatStaysOffIsToldFromWhatErrsOnce_data() {
  QTest::addColumn<double>("off");
  QTest::newRow("right") << 0.0;
  QTest::newRow("farther by 9 mm") << 9e-3;
}

void JudgeTest::WhatStaysOffIsToldFromWhatErrsOnce() {
  QFETCH(double, off);
  JudgeOptions options;
  options.gap = options.local = options.pull = 100.0;  // no single surface speaks
  options.behind = options.lifted = 1.0;
  options.motion = options.supported = options.least_supported = 0.0;
  options.unknown = 100.0;
  Judge judge(model_, rig_, {}, options);
  const Points nodes = moved({0.0, 0.0, off});
  judge.begin(first_, nodes);
  const std::vector<FollowedPoint> points = grid(rig_);
  constexpr int kTenth = 10 * 6 + 3;
  for (int k = 1; k <= kTenth; ++k) {
    OverlayFrame overlay;
    overlay.nodes_in_camera = nodes;
    const Validity said = judge.judge(first_, points, overlay);
    // The tenth surface is made in frame 60 and compared in frame 63.
    const bool is_late = k == kTenth;
    QCOMPARE(said, off > 0.0 && is_late ? Validity::surface_apart : Validity::valid);
  }
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
    QVERIFY_EXCEPTION_THROWN(options.validate(), InputError);
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
  refused([](JudgeOptions& o) { o.supported = -0.1; });
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
