// SPDX-License-Identifier: GPL-3.0-or-later
// What is judged of the pictures themselves: their contrast, both views of one moment, motion, and copies.
#include <QTest>

#include "few_points.h"
#include "glisson/guidance/tracker.h"
#include "judge.h"
#include "judged_film.h"
#include "motion_check.h"
#include "picture_check.h"
#include "triangulate.h"

using namespace glisson;
using namespace glisson::guidance;

class JudgePictureTest : public QObject, private phantom::JudgedFilm {
  Q_OBJECT
 private slots:
  void initTestCase() { make_film(); }
  void SmokeAndDarknessLoseSignalAndNoiseIsNone();
  void ALargePictureShowsAsMuchAsASmallOne();
  void RowsOfLargePicturesHaveAsMuchRoom();
  void RowsStayWithBothViewsOfOneMoment();
  void ViewsShiftedAlongTheirRowsChangeTheSizeOfAllThatIsSeen();
  void WhatIsWrongFromTheFirstIsNoNorm();
  void AViewIsHeldAgainstItsOwnStart();
  void NoiseIsNoMotionAndBreathIs_data();
  void NoiseIsNoMotionAndBreathIs();
  void OnlyAnOrderThatStereoTellsIsToldAsWrong();
  void ALensThatWetsIsToldOfItsView();
  void StandingPictureIsWithdrawn();
  void AStillPictureIsToldFromACopy_data();
  void AStillPictureIsToldFromACopy();
  void ACopyIsToldWhereTooFewPointsTellOfMotion();
  void WhatStoodIsAliveAgainWhereTooFewPointsTellOfMotion();

 private:
  /// Two in each part of the picture in which motion is asked for.
  std::vector<FollowedPoint> sparse() const {
    std::vector<FollowedPoint> points;
    for (int i = 0; i < 32; ++i) {
      FollowedPoint point;
      point.id = i;
      point.left = {80.0 * (i / 2 % 4) + 35.0 + 10.0 * (i % 2), 60.0 * (i / 8) + 30.0};
      point.p_in_camera = 0.12 * rig_.left.ray(point.left);
      point.right = rig_.right.project(rig_.right_from_left.rotation * point.p_in_camera +
                                       rig_.right_from_left.translation);
      points.push_back(point);
    }
    return points;
  }
};

void JudgePictureTest::SmokeAndDarknessLoseSignalAndNoiseIsNone() {
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

void JudgePictureTest::ALargePictureShowsAsMuchAsASmallOne() {
  // The same tissue before the same scope, 960 and 3840 pixels wide, each pixel with the same noise.
  const auto signal = [](int width) {
    const int height = width / 8;
    std::mt19937 random(5);
    std::normal_distribution<double> noise(0.0, 2.0);
    auto bytes = std::make_shared<std::vector<std::uint8_t>>();
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const double u = 150.0 * x / width, v = 150.0 * y / width;
        const double grey = 110.0 + 30.0 * std::sin(u) + 20.0 * std::cos(0.8 * u + v) + noise(random);
        bytes->push_back(static_cast<std::uint8_t>(std::lround(std::clamp(grey, 0.0, 240.0))));
      }
    return measure({width, height, 1, bytes}).signal();
  };
  const double small = signal(960), large = signal(3840);
  QVERIFY2(std::abs(large / small - 1.0) < 0.1, qPrintable(QString("%1 and %2").arg(small).arg(large)));
}

void JudgePictureTest::RowsOfLargePicturesHaveAsMuchRoom() {
  // A calibration that leaves 0.8 pixels in 960 of them leaves 3.2 in 3840: neither is a fault. What comes
  // later is one, in both.
  for (const int times : {1, 4}) {
    StereoRig rig = rig_;
    for (Camera* camera : {&rig.left, &rig.right}) {
      camera->matrix.topRows<2>() *= 3.0 * times;
      camera->width *= 3 * times;
      camera->height *= 3 * times;
    }
    MotionCheck check;
    std::vector<FollowedPoint> now = grid(rig);
    for (std::size_t i = 0; i < now.size(); ++i) now[i].right.y() += times * (i % 2 == 0 ? 0.3 : 1.3);
    for (int k = 0; k < 8; ++k) check.push(now, rig, k / 30.0);
    const double limit = check.rows_limit(JudgeOptions().rows);
    QVERIFY2(std::abs(check.rows()) < limit,
             qPrintable(QString("%1 times: %2 of %3").arg(times).arg(check.rows()).arg(limit)));
    for (FollowedPoint& point : now) point.right.y() += times * 0.9;
    check.push(now, rig, 8 / 30.0);
    QVERIFY2(std::abs(check.rows()) > limit,
             qPrintable(QString("%1 times: %2 of %3").arg(times).arg(check.rows()).arg(limit)));
  }
}

void JudgePictureTest::RowsStayWithBothViewsOfOneMoment() {
  MotionCheck check;
  std::vector<FollowedPoint> now = grid(rig_);
  for (int k = 0; k < 8; ++k) check.push(now, rig_, k / 30.0);
  QVERIFY(std::abs(check.rows()) < 1e-6);
  for (FollowedPoint& point : now) point.right.y() += 0.5;  // the right view shows another moment
  check.push(now, rig_, 8 / 30.0);
  QVERIFY2(std::abs(std::abs(check.rows()) - 0.5) < 0.05, qPrintable(QString::number(check.rows())));
}

void JudgePictureTest::ViewsShiftedAlongTheirRowsChangeTheSizeOfAllThatIsSeen() {
  const auto seen = [&](const auto& place, double shift) {
    std::vector<FollowedPoint> points = grid(rig_);
    for (FollowedPoint& point : points) {
      const Eigen::Vector3d p = place(point.p_in_camera);
      point.left = rig_.left.project(p);
      point.right = rig_.right.project(rig_.right_from_left.rotation * p + rig_.right_from_left.translation);
      point.right.x() += shift;
      point.p_in_camera = triangulate(rig_, point.left, point.right).p;
    }
    return points;
  };
  using Place = Eigen::Vector3d;
  const auto still = [](const Place& p) { return p; };
  const auto nearer = [](const Place& p) -> Place { return p + Place(4e-3, 2e-3, -25e-3); };
  const auto bent = [](const Place& p) -> Place { return {p.x(), p.y(), p.z() - 6.0 * p.x() * p.x()}; };
  const auto pulled = [](const Place& p) -> Place {
    return {p.x() * (p.x() > 0.0 ? 1.3 : 1.0), p.y(), p.z()};
  };
  const auto depth_off = [&](const auto& place, double shift) {
    MotionCheck check;
    check.push(seen(still, 0.0), rig_, 0.0);
    check.push(seen(place, shift), rig_, 1.0 / 30.0);
    return 1e3 * check.depth_off();
  };
  QVERIFY(std::abs(depth_off(still, 0.0)) < 1e-3);
  QVERIFY2(std::abs(depth_off(nearer, 0.0)) < 0.1, qPrintable(QString::number(depth_off(nearer, 0.0))));
  QVERIFY2(std::abs(depth_off(bent, 0.0)) < 4.0, qPrintable(QString::number(depth_off(bent, 0.0))));
  QVERIFY2(std::abs(depth_off(pulled, 0.0)) < 4.0, qPrintable(QString::number(depth_off(pulled, 0.0))));
  // Where the scope goes on, to other places, what was pulled before is no shift of a view now.
  MotionCheck going_on;
  for (int k = 0; k < 6; ++k) {
    auto points = k % 2 == 0 ? seen(still, 0.0) : seen(pulled, 0.0);
    for (FollowedPoint& point : points) point.id += 1000 * (k / 2);
    going_on.push(points, rig_, k / 30.0);
  }
  QVERIFY2(1e3 * std::abs(going_on.depth_off()) < 4.0,
           qPrintable(QString::number(1e3 * going_on.depth_off())));
  // Of 10.8 pixels of disparity one more or less is a ninth of the depth of 120 mm.
  QVERIFY2(depth_off(still, 1.0) > 9.0, qPrintable(QString::number(depth_off(still, 1.0))));
  QVERIFY2(depth_off(still, -1.0) < -8.0, qPrintable(QString::number(depth_off(still, -1.0))));

  Judge judge(model_, rig_, {}, {});
  judge.begin(first_, nodes_);
  OverlayFrame overlay;
  overlay.nodes_in_camera = nodes_;
  Validity found = Validity::valid;
  for (int k = 1; k <= 12; ++k) {
    StereoFrame frame = first_;
    frame.seconds = k / 30.0;
    found = judge.judge(frame, seen(still, 0.1 * k), overlay);
    QVERIFY2(k > 4 || found != Validity::views_apart, qPrintable(QString::number(k)));
  }
  QVERIFY2(found == Validity::views_apart, validity_code(found));
  QVERIFY(judge.strength() >= 1.0);  // no number of Evidence holds it
}

void JudgePictureTest::WhatIsWrongFromTheFirstIsNoNorm() {
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
    options.missing = 1.0, options.least_supported = 0.0;  // what is seen less is another reason
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

void JudgePictureTest::AViewIsHeldAgainstItsOwnStart() {
  const auto hazy_right = [&](double share, double seconds) {
    StereoFrame frame = first_;
    auto bytes = std::make_shared<std::vector<std::uint8_t>>(*frame.right.bytes);
    for (auto& byte : *bytes) byte = static_cast<std::uint8_t>(130.5 + share * byte);
    frame.right.bytes = std::move(bytes);
    frame.seconds = seconds;
    return frame;
  };
  JudgeOptions options;
  options.missing = 1.0, options.least_supported = 0.0;  // of the pictures alone
  options.unknown = options.gap = options.local = options.pull = options.mean_gap = 100.0;
  options.behind = options.lifted = options.before = 1.0;
  options.motion = 0.0;
  Judge judge(model_, rig_, {}, options);
  OverlayFrame overlay;
  overlay.nodes_in_camera = nodes_;
  judge.begin(hazy_right(0.12, 0.0), nodes_);
  for (int k = 1; k <= 10; ++k) {
    const Validity found = judge.judge(hazy_right(0.12, 0.1 * k), grid(rig_), overlay);
    QVERIFY2(found == Validity::valid, validity_code(found));
  }
  QVERIFY2(overlay.evidence.contrast > 0.9, qPrintable(QString::number(overlay.evidence.contrast)));
  Validity found = Validity::valid;
  for (int k = 11; k <= 14; ++k) found = judge.judge(hazy_right(0.04, 0.1 * k), grid(rig_), overlay);
  QVERIFY2(found == Validity::poor_picture, validity_code(found));
}

void JudgePictureTest::NoiseIsNoMotionAndBreathIs_data() {
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

void JudgePictureTest::NoiseIsNoMotionAndBreathIs() {
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
      now[i].left = from.left + Eigen::Vector2d{noise(random), noise(random) + down};
      now[i].right = from.right + Eigen::Vector2d{noise(random), noise(random) + down};
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

void JudgePictureTest::OnlyAnOrderThatStereoTellsIsToldAsWrong() {
  // Cameras that squint at the organ see it without any disparity: either order looks like a scene.
  for (const double squint : {0.0, 0.05}) {
    StereoRig rig = phantom::rig();
    rig.right_from_left.rotation = Eigen::AngleAxisd(squint, Eigen::Vector3d::UnitY()).toRotationMatrix();
    StereoFrame frame = phantom::film(model_, nodes_, rig, 0);
    FewPoints few(rig, frame, {});
    QVERIFY(few.reason(frame, {}) == Validity::too_few_points);
    std::swap(frame.left, frame.right);
    FrameClock later;
    for (const double seconds : {0.0, 1.0}) later.tick(seconds);
    const Validity told = few.reason(frame, later);
    QVERIFY2(told == (squint == 0.0 ? Validity::views_swapped : Validity::too_few_points),
             validity_code(told));
  }
}

void JudgePictureTest::ALensThatWetsIsToldOfItsView() {
  // Droplets spread a part of the light evenly; the sensor's noise stays.
  const auto wet = [](const Picture& picture, double clear) {
    std::mt19937 random(11);
    std::normal_distribution<double> noise(0.0, 1.5);
    Picture changed = picture;
    auto bytes = std::make_shared<std::vector<std::uint8_t>>(*picture.bytes);
    for (auto& byte : *bytes)
      byte = static_cast<std::uint8_t>(
          std::clamp(clear * byte + (1.0 - clear) * 90.0 + noise(random), 0.0, 255.0));
    changed.bytes = std::move(bytes);
    return changed;
  };
  FewPoints few(rig_, first_, {});
  for (const double clear : {0.4, 0.2, 0.1}) {
    StereoFrame frame = first_;
    frame.right = wet(first_.right, clear);
    const Validity one = few.reason(frame, {});
    QVERIFY2(one == Validity::view_lost, qPrintable(QString("%1: %2").arg(clear).arg(validity_code(one))));
    frame.left = wet(first_.left, clear);
    const Validity both = few.reason(frame, {});
    QVERIFY2(both == Validity::picture_lost,
             qPrintable(QString("%1: %2").arg(clear).arg(validity_code(both))));
  }
}

void JudgePictureTest::StandingPictureIsWithdrawn() {
  Registration start;
  start.nodes_in_camera = nodes_;
  Tracker tracker(model_, start, options());
  tracker.begin(rig_, first_, {});
  OverlayFrame overlay;
  for (int k = 1; k < 15; ++k) overlay = tracker.follow(first_);
  QVERIFY2(overlay.validity == Validity::picture_stands, validity_code(overlay.validity));
}

void JudgePictureTest::AStillPictureIsToldFromACopy_data() {
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

void JudgePictureTest::AStillPictureIsToldFromACopy() {
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
  QCOMPARE(tracker.evidence_strength() < 1.0, overlay.validity == Validity::valid);
}

void JudgePictureTest::ACopyIsToldWhereTooFewPointsTellOfMotion() {
  JudgeOptions options;
  options.missing = 1.0, options.least_supported = 0.0;  // only the picture is asked about
  Judge judge(model_, rig_, {}, options);
  judge.begin(first_, nodes_);
  std::vector<StereoFrame> alive;  // one place, noise of its own in each
  for (int k = 0; k < 4; ++k) alive.push_back(phantom::film(model_, nodes_, rig_, k));
  int k = 0;
  OverlayFrame overlay;
  const auto judged = [&](const StereoFrame& shown) {
    StereoFrame now = shown;
    now.seconds = ++k / 30.0;
    overlay.nodes_in_camera = nodes_;
    return judge.judge(now, sparse(), overlay);
  };
  for (int n = 0; n < 30; ++n)  // a camera before a still scene
    QCOMPARE(judged(alive[static_cast<std::size_t>(k % 4)]), Validity::valid);
  int copies = 0;
  while (copies < 30 && judged(first_) != Validity::picture_stands) ++copies;
  QVERIFY2(copies <= 12, qPrintable(QString("%1 copies, fresh %2").arg(copies).arg(overlay.evidence.fresh)));
  for (int n = 0; n < 20; ++n) QCOMPARE(judged(first_), Validity::picture_stands);
  Validity said = Validity::picture_stands;
  for (int n = 0; n < 10; ++n) said = judged(alive[static_cast<std::size_t>(k % 4)]);
  QCOMPARE(said, Validity::valid);
}

void JudgePictureTest::WhatStoodIsAliveAgainWhereTooFewPointsTellOfMotion() {
  // It moves, then its picture is repeated, then it goes on, and fewer points are followed than before.
  JudgeOptions options;
  options.missing = 1.0, options.least_supported = 0.0;  // only the picture is asked about
  Judge judge(model_, rig_, {}, options);
  judge.begin(first_, nodes_);
  std::vector<StereoFrame> alive;
  for (int k = 0; k < 4; ++k) alive.push_back(phantom::film(model_, nodes_, rig_, k));
  int k = 0;
  OverlayFrame overlay;
  const auto judged = [&](const StereoFrame& shown, const std::vector<FollowedPoint>& points) {
    StereoFrame now = shown;
    now.seconds = ++k / 30.0;
    overlay.nodes_in_camera = nodes_;
    return judge.judge(now, points, overlay);
  };
  std::vector<FollowedPoint> dense = grid(rig_);
  for (int n = 0; n < 20; ++n) {
    for (FollowedPoint& point : dense) point.left.x() += 0.4, point.right.x() += 0.4;
    const Validity said = judged(alive[static_cast<std::size_t>(k % 4)], dense);
    QVERIFY2(said == Validity::valid, validity_code(said));
  }
  Validity said = Validity::valid;
  for (int n = 0; n < 30; ++n) said = judged(alive[0], dense);
  QVERIFY2(said == Validity::picture_stands, validity_code(said));
  std::vector<FollowedPoint> few = sparse();
  for (FollowedPoint& point : few) point.id += 1000;
  for (int n = 0; n < 20; ++n) said = judged(frame(n), few);
  QVERIFY2(said == Validity::valid,
           qPrintable(QString("%1, fresh %2").arg(validity_code(said)).arg(overlay.evidence.fresh)));
}

QTEST_APPLESS_MAIN(JudgePictureTest)
#include "judge_picture_test.moc"
