// SPDX-License-Identifier: GPL-3.0-or-later
// The laparoscope moves fast, or is taken out and put back elsewhere.
#include <QTest>

#include "filmed_phantom.h"
#include "glisson/geometry/distance.h"
#include "glisson/guidance/tracker.h"

using namespace glisson;
using namespace glisson::guidance;

class RelocationTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase() {
    nodes_ = phantom::view().apply(model_.mesh.vertices);
    start_.nodes_in_camera = nodes_;
    start_.camera_from_ct = phantom::view();
    first_ = phantom::film(model_, nodes_, rig_, 0);
  }

  void AnOrganThatIsSeenElsewhereIsFoundAgain() {
    Tracker tracker = begun();
    // Taken out for eight frames, put back turned by 20 degrees and 18 mm aside.
    const Eigen::Vector3d middle = nodes_.colwise().mean();
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(0.35, Eigen::Vector3d(0.2, 0.1, 1.0).normalized()).matrix();
    const Points there = (((nodes_.rowwise() - middle.transpose()) * turn.transpose()).rowwise() +
                          (middle + Eigen::Vector3d(0.015, -0.008, 0.006)).transpose());
    int k = 1;
    for (; k < 9; ++k) {
      StereoFrame dark = first_;
      dark.left = phantom::plain(rig_.left, 4);
      dark.right = phantom::plain(rig_.right, 4);
      QVERIFY(tracker.follow(dark).validity != Validity::valid);
    }
    QVERIFY(point_errors(nodes_, there).mean > 0.015);
    const StereoFrame seen = phantom::film(model_, there, rig_, 1);
    const int back = k;
    OverlayFrame overlay;
    for (; k < back + 30 && overlay.validity != Validity::valid; ++k) overlay = tracker.follow(seen);
    QVERIFY2(overlay.validity == Validity::valid, "not within a second");
    const double error = point_errors(overlay.nodes_in_camera, there).mean;
    QVERIFY2(error < 1.5e-3, qPrintable(QString("%1 mm").arg(1e3 * error)));
  }

  void AScopePutBackElsewhereIsShownAgainWithinASecondAndNeverWrongly() {
    Tracker tracker(model_, start_, phantom::free_body());
    tracker.begin(rig_, first_, {});
    // Tissue that breathes, before a camera that is turned and shifted from frame 12 on.
    const Eigen::Vector3d middle = nodes_.colwise().mean();
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.3, Eigen::Vector3d(0.2, 0.1, 1.0).normalized()).matrix();
    const auto truth = [&](int k) {
      const Points breathing = nodes_.rowwise() + Eigen::RowVector3d(0.0, 0.4e-3 * k, -0.2e-3 * k);
      if (k < 12) return breathing;
      return Points(((breathing.rowwise() - middle.transpose()) * turn.transpose()).rowwise() +
                    (middle + Eigen::Vector3d(0.012, -0.01, 0.004)).transpose());
    };
    constexpr int kBack = 12;
    int shown = -1;
    for (int k = 1; k < kBack + 30 && shown < 0; ++k) {
      StereoFrame frame = phantom::film(model_, truth(k), rig_, k);
      const bool is_dark = k >= 6 && k < kBack;
      if (is_dark) frame.left = frame.right = phantom::plain(rig_.left, 4);
      const OverlayFrame overlay = tracker.follow(frame);
      const double error = point_errors(overlay.nodes_in_camera, truth(k)).mean;
      if (overlay.validity == Validity::valid)
        QVERIFY2(error < 3e-3, qPrintable(QString("frame %1: %2 mm").arg(k).arg(1e3 * error)));
      QVERIFY(!is_dark || overlay.validity != Validity::valid);
      if (k >= kBack && overlay.validity == Validity::valid) shown = k;
    }
    QVERIFY2(shown >= 0, "not within a second");
  }

  void AnotherOrganIsNotTakenForIt() {
    Tracker tracker = begun();
    PatientModel other = model_;
    other.surface.mesh.vertices.array() += 0.5;  // the texture is bound to the place in the CT
    const StereoFrame seen = phantom::film(other, nodes_, rig_, 1);
    for (int k = 1; k < 30; ++k) {
      const OverlayFrame overlay = tracker.follow(seen);
      QVERIFY(overlay.validity != Validity::valid);
      QVERIFY(point_errors(overlay.nodes_in_camera, nodes_).mean < 1e-3);
    }
  }

  void AFastCameraLeavesNothingBehind() {
    Tracker tracker = begun();
    const Points there = nodes_.rowwise() + Eigen::RowVector3d(0.007, 0.004, 0.0);
    const StereoFrame seen = phantom::film(model_, there, rig_, 1);
    // At once, and still after springs that stayed behind would have pulled it back.
    for (int k = 1; k < 20; ++k) {
      const OverlayFrame overlay = tracker.follow(seen);
      const double error = point_errors(overlay.nodes_in_camera, there).mean;
      QVERIFY(overlay.validity == Validity::valid);
      QVERIFY2(error < 0.8e-3, qPrintable(QString("frame %1: %2 mm").arg(k).arg(1e3 * error)));
    }
  }

 private:
  Tracker begun() const {
    TrackerOptions options;
    options.points = 80;
    options.judge.enabled = false;  // what it says of still pictures is not the matter here
    Tracker tracker(model_, start_, options);
    tracker.begin(rig_, first_, {});
    return tracker;
  }

  StereoRig rig_ = phantom::rig();
  PatientModel model_ = phantom::model(8, 6, 3);
  Points nodes_;
  Registration start_;
  StereoFrame first_;
};

QTEST_APPLESS_MAIN(RelocationTest)
#include "relocation_test.moc"
