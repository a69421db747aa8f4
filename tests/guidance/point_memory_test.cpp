// SPDX-License-Identifier: GPL-3.0-or-later
// Places that are seen again are where they were bound at first.
#include <QTest>
#include <numbers>
#include <opencv2/core.hpp>

#include "filmed_phantom.h"
#include "glisson/geometry/distance.h"
#include "glisson/guidance/tracker.h"
#include "patch.h"
#include "point_memory.h"

using namespace glisson;
using namespace glisson::guidance;

class PointMemoryTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void PatchIsFoundToAFractionOfAPixel_data();
  void PatchIsFoundToAFractionOfAPixel();
  void OtherTissueIsNotThePatch();
  void PlainOrOutsideIsNoPatch();
  void PointsThatSlippedAreTakenBack();
  void PlacesThatComeBackAreBoundAsAtFirst();
  void WhatWasBoundAtAWrongPlaceIsForgotten();
  void DarkFramesSayNothingOfSinglePoints();
  void LongFollowingDoesNotDrift();

 private:
  /// Light and dark of formulas, so that its place is known between pixels.
  static double texture(double x, double y) {
    return 120.0 + 35.0 * std::sin(0.55 * x + 0.2 * y) + 30.0 * std::sin(0.15 * x - 0.6 * y + 1.0) +
           20.0 * std::cos(0.35 * x + 0.45 * y);
  }
  template <class Shade>
  static cv::Mat drawn(const Shade& shade) {
    cv::Mat picture(120, 160, CV_8UC1);
    for (int y = 0; y < picture.rows; ++y)
      for (int x = 0; x < picture.cols; ++x)
        picture.at<std::uint8_t>(y, x) = cv::saturate_cast<std::uint8_t>(shade(x, y));
    return picture;
  }
  std::optional<Eigen::Vector3d> place_along(const Eigen::Vector2d& pixel) const {
    const ClosestPoint hit = surface().first_hit(Eigen::Vector3d::Zero(), rig_.left.ray(pixel), 0.0, 1.0);
    return hit.triangle < 0 ? std::nullopt : std::optional(hit.point);
  }
  registration::MovingSurface surface() const {
    registration::MovingSurface surface(model_);
    surface.move(nodes_);
    return surface;
  }
  /// A follower on the first frame whose points are all bound and remembered.
  struct Begun {
    explicit Begun(const PointMemoryTest& test) : follower(test.rig_, sixty()), memory(test.rig_) {
      follower.begin(test.film_[0], {});
      const registration::MovingSurface at_first = test.surface();
      follower.replenish([&](const Eigen::Vector2d& pixel) { return test.place_along(pixel); });
      std::vector<char> bound;
      for (const FollowedPoint& point : follower.points())
        bound.push_back(anchors.bind(point, at_first, 8e-3));
      follower.keep(bound);
      for (const FollowedPoint& point : follower.points())
        memory.remember(point, anchors.anchor(point.id), follower, at_first, 0);
    }
    static FollowerOptions sixty() {
      FollowerOptions options;
      options.points = 60;
      return options;
    }
    StereoFollower follower;
    AnchoredPoints anchors;
    PointMemory memory;
  };

  static constexpr int kFrames = 9;
  Points at(int frame) const {
    const double share = 0.5 - 0.5 * std::cos(std::numbers::pi * frame / (kFrames - 1));
    return phantom::breathed(model_, nodes_, share);
  }

  StereoRig rig_ = phantom::rig();
  PatientModel model_ = phantom::model(8, 6, 3);
  Points nodes_;
  std::vector<StereoFrame> film_;
};

void PointMemoryTest::initTestCase() {
  nodes_ = phantom::view().apply(model_.mesh.vertices);
  for (int k = 0; k < kFrames; ++k) film_.push_back(phantom::film(model_, at(k), rig_, k));
}

void PointMemoryTest::PatchIsFoundToAFractionOfAPixel_data() {
  QTest::addColumn<double>("turn");  // degrees
  QTest::addColumn<double>("size");
  QTest::addColumn<double>("gain");
  QTest::addColumn<double>("offset");
  QTest::newRow("shifted") << 0.0 << 1.0 << 1.0 << 0.0;
  QTest::newRow("darker") << 0.0 << 1.0 << 0.5 << 20.0;
  QTest::newRow("turned") << 40.0 << 1.0 << 1.0 << 0.0;
  QTest::newRow("nearer and turned") << -25.0 << 1.4 << 0.8 << 5.0;
  QTest::newRow("farther") << 10.0 << 0.75 << 1.0 << 0.0;
}

void PointMemoryTest::PatchIsFoundToAFractionOfAPixel() {
  QFETCH(double, turn);
  QFETCH(double, size);
  QFETCH(double, gain);
  QFETCH(double, offset);
  const Eigen::Vector2d then(70.3, 55.6), now(81.8, 62.1);
  Eigen::Matrix2d warp = size * Eigen::Rotation2Dd(turn * std::numbers::pi / 180.0).toRotationMatrix();
  warp(0, 1) += 0.1;
  const Eigen::Matrix2d back = warp.inverse();
  const auto patch = patch_at(drawn([](double x, double y) { return texture(x, y); }), then);
  QVERIFY(patch);
  const cv::Mat later = drawn([&](double x, double y) {
    const Eigen::Vector2d p = then + back * (Eigen::Vector2d(x, y) - now);
    return gain * texture(p.x(), p.y()) + offset;
  });
  const auto found = find_patch(later, *patch, warp, now + Eigen::Vector2d(1.6, -1.1), 3.0);
  QVERIFY(found);
  QVERIFY2((found->at - now).norm() < 0.05, qPrintable(QString::number((found->at - now).norm())));
  QVERIFY(found->likeness > 0.98);
}

void PointMemoryTest::OtherTissueIsNotThePatch() {
  const auto shade = [](int seed) {
    return [seed](double x, double y) {
      return 60.0 + 140.0 * phantom::value_noise(Eigen::Vector3d(x / 5.0, y / 5.0, 37.0 * seed));
    };
  };
  const auto patch = patch_at(drawn(shade(1)), {80.0, 60.0});
  QVERIFY(patch);
  int alike = 0;
  for (int seed = 2; seed < 22; ++seed) {
    const auto found = find_patch(drawn(shade(seed)), *patch, Eigen::Matrix2d::Identity(), {80.0, 60.0}, 3.0);
    alike += found && found->likeness > 0.8;
  }
  QCOMPARE(alike, 0);
}

void PointMemoryTest::PlainOrOutsideIsNoPatch() {
  const cv::Mat picture = drawn([](double x, double y) { return texture(x, y); });
  QVERIFY(!patch_at(picture, {5.0, 60.0}));
  QVERIFY(!patch_at(picture, {80.0, 112.0}));
  const auto patch = patch_at(picture, {80.0, 60.0});
  QVERIFY(patch);
  const Eigen::Matrix2d same = Eigen::Matrix2d::Identity();
  QVERIFY(!find_patch(picture, *patch, same, {2.0, 60.0}, 3.0));
  QVERIFY(!find_patch(picture, *patch, Eigen::Matrix2d::Zero(), {80.0, 60.0}, 3.0));
  QVERIFY(!find_patch(picture, *patch, 0.3 * same, {80.0, 60.0}, 3.0));
  const cv::Mat plain = drawn([](double, double) { return 90.0; });
  QVERIFY(!find_patch(plain, *patch, same, {80.0, 60.0}, 3.0));
  const auto nothing = patch_at(plain, {80.0, 60.0});
  QVERIFY(nothing && !find_patch(picture, *nothing, same, {80.0, 60.0}, 3.0));
}

void PointMemoryTest::PointsThatSlippedAreTakenBack() {
  Begun b(*this);
  const std::vector<FollowedPoint> first = b.follower.points();
  QVERIFY(first.size() > 30);
  const Eigen::Vector2d slip(1.2, -0.9);
  for (std::size_t i = 0; i < first.size(); ++i)
    QVERIFY(b.follower.put(i, first[i].left + slip, first[i].right + slip));
  // Each has its turn within six frames.
  for (int frame = 1; frame <= 6; ++frame) b.memory.confirm(b.follower, surface());
  std::vector<double> off;
  for (std::size_t i = 0; i < first.size(); ++i)
    off.push_back((b.follower.points()[i].left - first[i].left).norm());
  std::sort(off.begin(), off.end());
  QVERIFY2(off[off.size() * 9 / 10] < 0.1, qPrintable(QString::number(off[off.size() * 9 / 10])));
}

void PointMemoryTest::PlacesThatComeBackAreBoundAsAtFirst() {
  Begun b(*this);
  std::map<int, FollowedPoint> first;
  for (const FollowedPoint& point : b.follower.points()) first[point.id] = point;
  b.follower.begin(film_[2], {});
  registration::MovingSurface moved = surface();
  // The model is a millimetre off: what is found again says so.
  moved.move(at(2).rowwise() + Eigen::RowVector3d(1e-3, 0.0, 0.0));
  AnchoredPoints anchors;
  const int found = b.memory.recall(b.follower, anchors, moved, 60, 5.0, 2);
  QVERIFY2(found > static_cast<int>(0.6 * static_cast<double>(first.size())),
           qPrintable(QString("%1 of %2").arg(found).arg(first.size())));
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& gap : anchors.gaps(b.follower.points(), moved)) sum += gap;
  const double across = sum.x() / found;
  QVERIFY2(std::abs(across + 1e-3) < 0.2e-3, qPrintable(QString::number(1e3 * across)));
  for (const FollowedPoint& point : b.follower.points()) QVERIFY(first.contains(point.id));
}

void PointMemoryTest::WhatWasBoundAtAWrongPlaceIsForgotten() {
  Begun b(*this);
  const std::size_t all = b.memory.size();
  b.memory.forget_since(0);
  QCOMPARE(b.memory.size(), all);
  b.memory.forget_since(-1);
  QCOMPARE(b.memory.size(), std::size_t{0});
}

void PointMemoryTest::DarkFramesSayNothingOfSinglePoints() {
  Registration start;
  start.nodes_in_camera = nodes_;
  TrackerOptions options = phantom::free_body();
  options.judge.enabled = false;
  options.points = 50;  // of which half would be fewer than it needs
  Tracker tracker(model_, start, options);
  tracker.begin(rig_, film_[0], {});
  const auto seen = [&](StereoFrame frame, int n) {
    frame.index = n;
    frame.seconds = n / 30.0;
    return tracker.follow(frame);
  };
  StereoFrame dark = film_[0];
  const auto black = std::make_shared<std::vector<std::uint8_t>>(dark.left.bytes->size(), 3);
  dark.left.bytes = dark.right.bytes = black;
  constexpr int kBefore = 12, kDark = 120, kAfter = 12;
  int n = 0, before = 0;
  for (; n < kBefore; ++n) before = seen(film_[0], n).pairs;
  QVERIFY(before >= 40);
  for (; n < kBefore + kDark; ++n) QVERIFY(seen(dark, n).validity != Validity::valid);
  for (; n < kBefore + kDark + kAfter; ++n) {
    const OverlayFrame overlay = seen(film_[0], n);
    QVERIFY2(overlay.validity == Validity::valid && 10 * overlay.pairs >= 9 * before,
             qPrintable(QString("%1 of %2 pairs").arg(overlay.pairs).arg(before)));
  }
}

void PointMemoryTest::LongFollowingDoesNotDrift() {
  // The same pictures forwards and backwards for 40 s: whatever is off more at the end than at first has
  // added up.
  Registration start;
  start.nodes_in_camera = nodes_;
  TrackerOptions options = phantom::free_body();
  options.judge.enabled = false;
  Tracker tracker(model_, start, options);
  tracker.begin(rig_, film_[0], {});
  constexpr int kPeriod = 2 * (kFrames - 1), kPeriods = 75;
  double first = 0.0, last = 0.0, residual = 0.0;
  for (int n = 1; n <= kPeriod * kPeriods; ++n) {
    const int phase = n % kPeriod, k = phase < kFrames ? phase : kPeriod - phase;
    const OverlayFrame overlay = tracker.follow(film_[static_cast<std::size_t>(k)]);
    QVERIFY(overlay.validity == Validity::valid);
    const double error = point_errors(overlay.nodes_in_camera, at(k)).mean / kPeriod;
    if (n <= kPeriod) first += error;
    if (n <= kPeriod * (kPeriods - 1)) continue;
    last += error;
    residual += overlay.residual / kPeriod;
  }
  QVERIFY2(last < first + 0.2e-3 && residual < 0.6e-3,
           qPrintable(QString("%1 mm at first, %2 at last, residual %3")
                          .arg(1e3 * first)
                          .arg(1e3 * last)
                          .arg(1e3 * residual)));
}

QTEST_GUILESS_MAIN(PointMemoryTest)
#include "point_memory_test.moc"
