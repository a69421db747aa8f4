// SPDX-License-Identifier: GPL-3.0-or-later
// What somebody else says is not liver neither pulls nor is begun on, and no mask makes anything pull.
#include <QTest>

#include "filmed_phantom.h"
#include "glisson/geometry/distance.h"
#include "glisson/guidance/tracker.h"
#include "held_out.h"

using namespace glisson;
using namespace glisson::guidance;

class HeldOutTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void AToolThatIsMaskedPullsNoMore();
  void AMaskOfAFormerFrameIsAskedWhereThePointsWereThen();
  void AnOldMaskIsAskedWhereThePointsWereAtAnyRate_data();
  void AnOldMaskIsAskedWhereThePointsWereAtAnyRate();
  void WhatMasksAllWithdrawsAndWhatMasksMostDegrades();
  void AMaskOfAnotherSizeIsNone();

 private:
  static constexpr int kTool = 70, kFrames = 48;  ///< pixels of its side
  /// Left edge of the tool in the left picture.
  static int tool_at(int k) { return 70 + k; }
  /// A textured square over both pictures at the depth of the organ's middle, which moves to the right.
  StereoFrame with_tool(int k) const;
  std::shared_ptr<const PictureMask> mask(int k, int left, int right) const;
  Tracker begun(const std::shared_ptr<const PictureMask>& first) const {
    Tracker tracker(film_.model, film_.start, phantom::free_body());
    tracker.see(first);
    tracker.begin(film_.rig, with_tool(0), {});
    return tracker;
  }

  phantom::BreathingFilm film_;
  int shift_ = 0;  ///< pixels from the left to the right picture
};

void HeldOutTest::initTestCase() {
  Eigen::Vector3d middle = film_.nodes.colwise().mean().transpose();
  middle.z() = film_.nodes.col(2).minCoeff() + 2e-3;
  const Eigen::Vector3d in_right =
      film_.rig.right_from_left.rotation * middle + film_.rig.right_from_left.translation;
  shift_ = static_cast<int>(
      std::lround(film_.rig.right.project(in_right).x() - film_.rig.left.project(middle).x()));
}

StereoFrame HeldOutTest::with_tool(int k) const {
  StereoFrame frame = film_.frame(k);
  for (Picture* view : {&frame.left, &frame.right}) {
    auto bytes = std::make_shared<std::vector<std::uint8_t>>(*view->bytes);
    const int from = tool_at(k) + (view == &frame.left ? 0 : shift_);
    for (int v = 0; v < kTool; ++v)
      for (int u = 0; u < kTool; ++u) {
        const int x = from + u, y = 85 + v;
        if (x < 0 || x >= view->width) continue;
        const double texture = phantom::value_noise(Eigen::Vector3d(u, v, 7.0) / 5.0);
        (*bytes)[static_cast<std::size_t>(y * view->width + x)] =
            static_cast<std::uint8_t>(40.0 + 180.0 * texture);
      }
    view->bytes = bytes;
  }
  return frame;
}

std::shared_ptr<const PictureMask> HeldOutTest::mask(int k, int left, int right) const {
  const Camera& camera = film_.rig.left;
  auto bytes =
      std::make_shared<std::vector<std::uint8_t>>(static_cast<std::size_t>(camera.width * camera.height));
  for (int y = 0; y < camera.height; ++y)
    for (int x = std::max(0, left); x < std::min(camera.width, right); ++x)
      (*bytes)[static_cast<std::size_t>(y * camera.width + x)] = 255;
  return std::make_shared<const PictureMask>(
      PictureMask{{camera.width, camera.height, 1, bytes}, k, k / 30.0});
}

void HeldOutTest::AToolThatIsMaskedPullsNoMore() {
  const auto error = [&](bool is_masked, int& on_tool) {
    const auto of = [&](int k) { return is_masked ? mask(k, tool_at(k), tool_at(k) + kTool) : nullptr; };
    Tracker tracker = begun(of(0));
    double sum = 0.0;
    for (int k = 1; k < kFrames; ++k) {
      tracker.see(of(k));
      const OverlayFrame overlay = tracker.follow(with_tool(k));
      sum += point_errors(overlay.nodes_in_camera, film_.truth(k)).mean;
    }
    const int last = kFrames;
    tracker.see(mask(last, tool_at(last), tool_at(last) + kTool));
    on_tool = tracker.follow(with_tool(last)).mask->held_out;
    return sum / (kFrames - 1);
  };
  int left_on_tool = 0, masked_on_tool = 0;
  const double classical = error(false, left_on_tool), masked = error(true, masked_on_tool);
  qInfo("mean error of the nodes: %.2f mm without a mask, %.2f mm with it; points on the tool: %d, %d",
        1e3 * classical, 1e3 * masked, left_on_tool, masked_on_tool);
  QVERIFY(masked < 0.8 * classical);
  QVERIFY(masked_on_tool < left_on_tool);
}

void HeldOutTest::AMaskOfAFormerFrameIsAskedWhereThePointsWereThen() {
  Tracker tracker = begun(nullptr);
  tracker.follow(with_tool(1));
  QVERIFY(!tracker.follow(with_tool(2)).mask);
  tracker.see(mask(0, tool_at(0), tool_at(0) + kTool));
  const OverlayFrame overlay = tracker.follow(with_tool(3));
  QVERIFY(overlay.mask && overlay.mask->held_out > 3 && overlay.mask->share > 0.05);
  QVERIFY(std::abs(overlay.mask->age - 0.1) < 1e-9);
  tracker.see(nullptr);
  QVERIFY(!tracker.follow(with_tool(4)).mask);
}

void HeldOutTest::AnOldMaskIsAskedWhereThePointsWereAtAnyRate_data() {
  QTest::addColumn<double>("rate");
  for (const double rate : {5.0, 30.0, 60.0, 120.0})
    QTest::newRow(qPrintable(QString("%1 frames a second").arg(rate))) << rate;
}

void HeldOutTest::AnOldMaskIsAskedWhereThePointsWereAtAnyRate() {
  // The point was on the tool, and has come out of it in the eight seconds since.
  QFETCH(double, rate);
  HeldOut held_out(film_.rig, 17, 0.5);
  FollowedPoint point;
  const int frames = static_cast<int>(8.0 * rate);
  point.left = {300.0, 120.0};
  held_out.remember(0, 0.0, {point});  // of another source, whose frames have the same numbers
  held_out.remember(7777, 0.0, {point});
  for (int k = 0; k <= frames; ++k) {
    point.left = {100.0 + 150.0 * k / frames, 120.0};
    held_out.remember(k, k / rate, {point});
  }
  PictureMask first = *mask(0, 60, 140);
  held_out.take(std::make_shared<const PictureMask>(first), 8.0, film_.model.surface.mesh);
  QCOMPARE(held_out.free({point}), std::vector<char>{0});
}

void HeldOutTest::WhatMasksAllWithdrawsAndWhatMasksMostDegrades() {
  Tracker tracker(film_.model, film_.start, phantom::free_body());
  tracker.begin(film_.rig, film_.frame(0), {});
  QVERIFY(tracker.follow(film_.frame(1)).validity == Validity::valid);
  tracker.see(mask(2, 0, 320));
  OverlayFrame overlay = tracker.follow(film_.frame(2));
  QVERIFY2(overlay.validity == Validity::masked_out, validity_code(overlay.validity));
  QVERIFY(overlay.level() == Level::withdrawn && overlay.mask->share > 0.99);
  tracker.see(nullptr);
  overlay = tracker.follow(film_.frame(3));
  QVERIFY2(overlay.validity == Validity::valid, validity_code(overlay.validity));
}

void HeldOutTest::AMaskOfAnotherSizeIsNone() {
  Tracker tracker(film_.model, film_.start, phantom::free_body());
  tracker.begin(film_.rig, film_.frame(0), {});
  tracker.see(std::make_shared<const PictureMask>(PictureMask{phantom::plain(Camera(), 255), 1, 0.0}));
  const OverlayFrame overlay = tracker.follow(film_.frame(1));
  QVERIFY(overlay.validity == Validity::valid && !overlay.mask);
}

QTEST_APPLESS_MAIN(HeldOutTest)
#include "held_out_test.moc"
