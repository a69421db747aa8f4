// SPDX-License-Identifier: GPL-3.0-or-later
#include "rigid.h"

#include <QTest>
#include <algorithm>
#include <limits>

#include "cavity.h"
#include "glisson/core/error.h"
#include "glisson/geometry/distance.h"
#include "lying_phantom.h"
#include "phantom.h"

using namespace glisson;
using namespace glisson::registration;

class RigidTest : public QObject {
  Q_OBJECT
 private slots:
  void AnyOrientationIsFoundFromAPartialNoisyView_data();
  void AnyOrientationIsFoundFromAPartialNoisyView();
  void APoseSetByHandIsRefined_data();
  void APoseSetByHandIsRefined();
  void AnotherPlaceIsAmongTheAlternatives();
  void MovingTheCloudMovesTheResult();
  void SameSeedGivesSameBits();
  void WithoutLabelsItSaysSo();
  void CloudWithoutNormalsIsAligned();
  void ALaparoscopeStandsBeforeOrBelowTheLiver_data();
  void ALaparoscopeStandsBeforeOrBelowTheLiver();
  void WhereItStandsDoesNotDependOnItsFrame();
  void NoPlaceIsSeenFromBehindThePatient();
  void CancelIsObeyed();
  void TooFewPointsAreRefused();
  void UnusableOptionsAreRefused();

 private:
  static bool has(const std::vector<std::string>& doubts, const char* doubt) {
    return std::find(doubts.begin(), doubts.end(), doubt) != doubts.end();
  }
  /// The cloud comes from another, finer mesh of the same body.
  PatientModel model_ = phantom::model(12, 9, 5), truth_ = phantom::model(17, 14, 7);
  LabelledCloud seen(const CameraFromCt& pose, double share) const {
    phantom::PatchOptions options;
    options.share = share;
    options.noise = 1e-3;
    options.outliers = 10;
    return phantom::patch(truth_, pose.apply(truth_.mesh.vertices), options);
  }
  double error(const CameraFromCt& found, const CameraFromCt& true_pose) const {
    return point_errors(found.apply(model_.mesh.vertices), true_pose.apply(model_.mesh.vertices)).mean;
  }
};

void RigidTest::AnyOrientationIsFoundFromAPartialNoisyView_data() {
  QTest::addColumn<double>("turn");
  QTest::addColumn<double>("share");
  QTest::newRow("30 %, upright") << 0.0 << 0.30;
  QTest::newRow("30 %, turned") << 2.5 << 0.30;
  QTest::newRow("12 %, turned back") << -2.0 << 0.12;
  QTest::newRow("12 %, turned") << 1.0 << 0.12;
}

void RigidTest::AnyOrientationIsFoundFromAPartialNoisyView() {
  QFETCH(double, turn);
  QFETCH(double, share);
  const CameraFromCt pose = phantom::view(turn);
  const auto start = align_rigid(model_, seen(pose, share), {}, RunContext());
  QVERIFY(start.has_value());
  const double e = error(start->camera_from_ct, pose);
  QVERIFY2(e < 4e-3, qPrintable(QString("mean error %1 mm").arg(1e3 * e)));
  QVERIFY(start->residual < 2e-3);
  QVERIFY(!has(start->doubts, "few_margin_points"));
}

void RigidTest::APoseSetByHandIsRefined_data() {
  QTest::addColumn<Eigen::Vector3d>("turn");
  QTest::addColumn<Eigen::Vector3d>("shift");
  QTest::newRow("beside") << Eigen::Vector3d(0, 0, 0) << Eigen::Vector3d(0.02, -0.01, 0);
  QTest::newRow("too near, rolled") << Eigen::Vector3d(0, 0, 0.35) << Eigen::Vector3d(0, 0.005, -0.02);
  QTest::newRow("tipped") << Eigen::Vector3d(0.3, -0.2, 0) << Eigen::Vector3d(-0.01, 0, 0.015);
}

void RigidTest::APoseSetByHandIsRefined() {
  QFETCH(Eigen::Vector3d, turn);
  QFETCH(Eigen::Vector3d, shift);
  const CameraFromCt pose = phantom::view(0.4);
  CameraFromCt near = pose;
  if (turn.norm() > 0.0)
    near.rotation = Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix() * pose.rotation;
  near.translation += shift;
  QVERIFY(error(near, pose) > 0.018);
  const auto start = align_rigid_near(model_, seen(pose, 0.3), near, {}, RunContext());
  QVERIFY(start.has_value());
  const double e = error(start->camera_from_ct, pose);
  QVERIFY2(e < 4e-3, qPrintable(QString("mean error %1 mm").arg(1e3 * e)));
  // Where the hand had put it is tried, too.
  QVERIFY(start->alternatives.back().translation == near.translation);
}

void RigidTest::AnotherPlaceIsAmongTheAlternatives() {
  // However well it fits where it belongs: neighbours of the best pose do not fill the list.
  const auto start = align_rigid(model_, seen(phantom::view(), 0.3), {}, RunContext());
  QVERIFY(start->alternatives.size() <= 8);
  const auto is_far = [&](const CameraFromCt& pose) { return error(pose, start->camera_from_ct) > 35e-3; };
  QVERIFY(std::any_of(start->alternatives.begin(), start->alternatives.end(), is_far));
  QVERIFY(is_far(start->alternatives.back()));  // after those that are near
}

void RigidTest::MovingTheCloudMovesTheResult() {
  // About the camera's centre, so that the same things are seen.
  const CameraFromCt pose = phantom::view();
  LabelledCloud cloud = seen(pose, 0.3);
  Rigid<CameraFrame, CameraFrame> moved;
  moved.rotation = Eigen::AngleAxisd(0.9, Eigen::Vector3d(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
  const auto one = align_rigid(model_, cloud, {}, RunContext());
  cloud.points = moved.apply(cloud.points);
  cloud.normals = (cloud.normals * moved.rotation.transpose()).eval();
  const auto other = align_rigid(model_, cloud, {}, RunContext());
  const auto together = moved * one->camera_from_ct;
  QVERIFY(error(other->camera_from_ct, together) < 1e-3);
}

void RigidTest::SameSeedGivesSameBits() {
  const LabelledCloud cloud = seen(phantom::view(), 0.3);
  RigidOptions few;
  few.starts = 30;
  const auto a = align_rigid(model_, cloud, few, RunContext()),
             b = align_rigid(model_, cloud, few, RunContext());
  QVERIFY(a->camera_from_ct.rotation == b->camera_from_ct.rotation);
  QVERIFY(a->camera_from_ct.translation == b->camera_from_ct.translation);
}

void RigidTest::WithoutLabelsItSaysSo() {
  LabelledCloud cloud = seen(phantom::view(), 0.2);
  cloud.features.clear();
  RigidOptions few;
  few.starts = 30;
  const auto start = align_rigid(model_, cloud, few, RunContext());
  QVERIFY(has(start->doubts, "few_margin_points"));
}

void RigidTest::CloudWithoutNormalsIsAligned() {
  const CameraFromCt pose = phantom::view(1.0);
  LabelledCloud cloud = seen(pose, 0.3);
  cloud.normals.resize(0, 3);
  QVERIFY(error(align_rigid(model_, cloud, {}, RunContext())->camera_from_ct, pose) < 4e-3);
}

void RigidTest::ALaparoscopeStandsBeforeOrBelowTheLiver_data() {
  QTest::addColumn<Eigen::Vector3d>("from");  // LPS
  QTest::addColumn<bool>("can");
  QTest::newRow("before") << Eigen::Vector3d(0, -1, 0) << true;
  QTest::newRow("below") << Eigen::Vector3d(0, 0, -1) << true;
  QTest::newRow("the patient's left") << Eigen::Vector3d(1, 0, 0) << true;
  QTest::newRow("the patient's right") << Eigen::Vector3d(-1, 0, 0) << true;
  QTest::newRow("below and behind") << Eigen::Vector3d(0, 1, -1) << true;
  QTest::newRow("behind") << Eigen::Vector3d(0, 1, 0) << false;
  QTest::newRow("above") << Eigen::Vector3d(0, 0, 1) << false;
  QTest::newRow("behind and to the left") << Eigen::Vector3d(1, 1, 0) << false;
}

void RigidTest::ALaparoscopeStandsBeforeOrBelowTheLiver() {
  QFETCH(Eigen::Vector3d, from);
  QFETCH(bool, can);
  const Eigen::Vector3d middle = model_.mesh.vertices.colwise().mean().transpose();
  for (const double distance : {0.08, 0.2})
    QCOMPARE(Cavity(model_).holds(Point<CtFrame>(middle + distance * from.normalized())), can);
}

void RigidTest::WhereItStandsDoesNotDependOnItsFrame() {
  const PatientModel model = phantom::lying(9, 8, 4);
  const Cavity cavity(model);
  LabelledCloud cloud;
  cloud.points = Points::Random(10, 3);
  int held = 0;
  for (int k = 0; k < 12; ++k) {
    // The camera looks at the middle from all around.
    CameraFromCt pose;
    pose.rotation = rotation_by(Eigen::Vector3d(0.5 * k, 0.1, 0.0));
    pose.translation =
        Eigen::Vector3d(0, 0, 0.2) - pose.rotation * model.mesh.vertices.colwise().mean().transpose();
    Rigid<CameraFrame, CameraFrame> moved;
    moved.rotation = rotation_by(Eigen::Vector3d(0.4, -1.0, 2.0));
    moved.translation = Eigen::Vector3d(0.1, 0.2, -0.3);
    LabelledCloud elsewhere = cloud;
    elsewhere.points = moved.apply(cloud.points);
    elsewhere.eyes = moved.translation.transpose();
    QCOMPARE(cavity.holds(moved * pose, elsewhere), cavity.holds(pose, cloud));
    held += cavity.holds(pose, cloud) ? 1 : 0;
  }
  QVERIFY(held > 3 && held < 9);
}

void RigidTest::NoPlaceIsSeenFromBehindThePatient() {
  const PatientModel model = phantom::lying(12, 9, 5), truth = phantom::lying(17, 14, 7);
  const CameraFromCt pose = phantom::lying_view();
  phantom::PatchOptions options;
  options.share = 0.12;
  options.noise = 1e-3;
  LabelledCloud cloud = phantom::patch(truth, pose.apply(truth.mesh.vertices), options);
  cloud.features.clear();
  const Cavity cavity(model);
  QVERIFY(cavity.holds(pose, cloud));
  RigidOptions laparoscope;
  laparoscope.from_cavity = true;
  const auto behind = [&](const RigidOptions& rigid) {
    const auto start = align_rigid(model, cloud, rigid, RunContext());
    return std::count_if(start->alternatives.begin(), start->alternatives.end(),
                         [&](const CameraFromCt& other) { return !cavity.holds(other, cloud); }) +
           (cavity.holds(start->camera_from_ct, cloud) ? 0 : 100);
  };
  QVERIFY(behind({}) > 0);
  QCOMPARE(behind(laparoscope), 0);
}

void RigidTest::CancelIsObeyed() {
  const auto flag = std::make_shared<CancelFlag>();
  int calls = 0;
  const RunContext context(
      [&](double, std::string_view) {
        if (++calls == 5) flag->request();
      },
      flag, 1);
  QVERIFY(!align_rigid(model_, seen(phantom::view(), 0.2), {}, context).has_value());
  QVERIFY(calls < 10);
}

void RigidTest::TooFewPointsAreRefused() {
  LabelledCloud cloud;
  cloud.points = Points::Random(9, 3);
  QVERIFY_THROWS_EXCEPTION(InputError, align_rigid(model_, cloud, {}, RunContext()));
  cloud.points = Points::Random(20, 3);
  cloud.points(3, 0) = std::numeric_limits<double>::infinity();
  QVERIFY_THROWS_EXCEPTION(InputError, align_rigid(model_, cloud, {}, RunContext()));
}

void RigidTest::UnusableOptionsAreRefused() {
  RigidOptions none;
  none.starts = 0;
  QVERIFY_THROWS_EXCEPTION(InputError, none.validate());
  RigidOptions all;
  all.outlier_share = 1.0;
  QVERIFY_THROWS_EXCEPTION(InputError, all.validate());
}

QTEST_APPLESS_MAIN(RigidTest)
#include "rigid_test.moc"
