// SPDX-License-Identifier: GPL-3.0-or-later
// An overlay is wrong where it is wrong on the picture, though the program's numbers be right.
#include "live_truth.h"

#include <QTest>
#include <algorithm>

#include "live_roc.h"

namespace glisson::experiments {

class LiveTruthTest : public QObject {
  Q_OBJECT
 private slots:
  void init();
  void WithoutAFaultItIsTheDistance();
  void NoOverlayOnAMirrorImageIsRight();
  void AWrongFocalLengthDrawsBesideTheOrgan();
  void WhatStandsOnTheOtherViewIsOffByTheBaseline();
  void ARightCameraThatIsWrongDrawsRightAllTheSame();

 private:
  LiveFault fault(const char* name) const {
    const auto all = live_faults(rig_, 40, 119, 1);
    return *std::find_if(all.begin(), all.end(), [&](const LiveFault& one) { return one.name == name; });
  }
  double error(const char* name, int frame, const Eigen::Vector3d& found) const {
    return drawn_error(fault(name), rig_, frame, found, truth_);
  }

  StereoRig rig_;
  const Eigen::Vector3d truth_{0.04, -0.01, 0.12};
};

void LiveTruthTest::init() {
  for (Camera* camera : {&rig_.left, &rig_.right}) {
    camera->width = 960;
    camera->height = 540;
    camera->matrix << 700.0, 0.0, 480.0, 0.0, 700.0, 270.0, 0.0, 0.0, 1.0;
  }
  rig_.right_from_left.translation = Eigen::Vector3d(-5e-3, 0.0, 0.0);
}

void LiveTruthTest::WithoutAFaultItIsTheDistance() {
  const Eigen::Vector3d off(3e-3, 4e-3, 0.0);
  QVERIFY(std::abs(error("none", 50, truth_ + off) - 5e-3) < 1e-12);
  QVERIFY(std::abs(error("frozen", 50, truth_ + off) - 5e-3) < 1e-12);
}

void LiveTruthTest::NoOverlayOnAMirrorImageIsRight() {
  QVERIFY(shows_another_organ(fault("mirrored")) && shows_another_organ(fault("another_patient")));
  QVERIFY(!shows_another_organ(fault("none")) && !shows_another_organ(fault("swapped")));
  QVERIFY(kNowhere > kFarFrame);
}

void LiveTruthTest::AWrongFocalLengthDrawsBesideTheOrgan() {
  // x' = 0.85 f x / z: at the depth z it stands 0.15 of the way to the axis beside the place.
  const double beside = 0.15 * truth_.head<2>().norm();
  QVERIFY(std::abs(error("focal_85", 3, truth_) - beside) < 1e-6);
}

void LiveTruthTest::WhatStandsOnTheOtherViewIsOffByTheBaseline() {
  QVERIFY(error("swapped", 39, truth_) < 1e-12);
  QVERIFY(std::abs(error("swapped", 40, truth_) - 5e-3) < 1e-6);
}

void LiveTruthTest::ARightCameraThatIsWrongDrawsRightAllTheSame() {
  QVERIFY(error("baseline_120", 3, truth_) < 1e-6);
  QVERIFY(error("centre_20px", 3, truth_) < 1e-6);
}

}  // namespace glisson::experiments

QTEST_GUILESS_MAIN(glisson::experiments::LiveTruthTest)
#include "live_truth_test.moc"
