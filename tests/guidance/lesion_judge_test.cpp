// SPDX-License-Identifier: GPL-3.0-or-later
// What is said of one lesion: against closed forms.
#include <Eigen/Geometry>
#include <QTest>
#include <cmath>

#include "glisson/core/error.h"
#include "glisson/guidance/lesion_judge.h"
#include "glisson/patient/label_map.h"
#include "phantom.h"

using namespace glisson;
using namespace glisson::guidance;

namespace {

constexpr double kChi = 7.8147;  // 95 % of chi-square with three degrees of freedom

/// @param sigma of its place in each direction, metres, that gives a region of this reach.
Eigen::Matrix3d round_spread(double reach) { return Eigen::Matrix3d::Identity() * reach * reach / kChi; }

}  // namespace

class LesionJudgeTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void TheRegistrationsErrorDecidesAtTheStart_data();
  void TheRegistrationsErrorDecidesAtTheStart();
  void AnUnknownErrorIsWithdrawn();
  void TheSpreadTurnsWithTheOrgan();
  void PointsFarFromABentOrganSayLittle();
  void WhatIsUnseenIsKnownLessAndLess();
  void ASourceWithoutTimesLeavesNothingKnown_data();
  void ASourceWithoutTimesLeavesNothingKnown();
  void WhatIsUnseenStaysSoWhenARegistrationIsTaken();
  void ATakenRegistrationSaysHowFarItsLesionsAreKnown();
  void NearPointsMakeItKnownAgain();
  void WhatWasOutOfSightAtFirstIsNotCountedTwice();
  void TheWholeIsNeverBetterThanItsLesions();
  void ARefusedStartIsNeverValid();
  void OneFrameChangesNothing();
  void UnusableOptionsAreRefused();

 private:
  Registration start(const Eigen::Matrix3d& covariance) const {
    Registration registration;
    registration.nodes_in_camera = model_.mesh.vertices.rowwise() + Eigen::RowVector3d(0.0, 0.0, 0.15);
    registration.lesions = {{structure::kFirstLesion, covariance}};
    return registration;
  }
  OverlayFrame frame(const Points& nodes, int index) const {
    OverlayFrame overlay;
    overlay.validity = Validity::valid;
    overlay.index = index;
    overlay.seconds = index / 30.0;
    overlay.nodes_in_camera = nodes;
    return overlay;
  }
  /// Five points at a distance from the lesion, along x.
  Points points_at(const Points& nodes, double distance) const {
    Points centre(1, 3);
    centre.row(0) = lesion_.transpose();
    const Points now = bind_points(model_.mesh, centre).apply(model_.mesh, nodes);
    Points points(5, 3);
    for (Eigen::Index i = 0; i < 5; ++i) points.row(i) = now.row(0) + Eigen::RowVector3d(distance, 0.0, 0.0);
    return points;
  }

  PatientModel model_ = phantom::model(8, 6, 3);
  Eigen::Vector3d lesion_ = Eigen::Vector3d::Zero();
};

void LesionJudgeTest::initTestCase() {
  lesion_ = model_.mesh.vertices.colwise().mean().transpose();
  NamedSurface surface;
  surface.structure = structure::kFirstLesion;
  surface.mesh.vertices.resize(6, 3);
  for (int k = 0; k < 3; ++k)
    for (const int side : {0, 1})
      surface.mesh.vertices.row(2 * k + side) =
          (lesion_ + (side == 0 ? -5e-3 : 5e-3) * Eigen::Vector3d::Unit(k)).transpose();
  surface.mesh.triangles.resize(8, 3);
  surface.mesh.triangles << 0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5;
  model_.surfaces.push_back(surface);
  QCOMPARE(lesion_centres(model_).size(), std::size_t{1});
}

void LesionJudgeTest::TheRegistrationsErrorDecidesAtTheStart_data() {
  QTest::addColumn<double>("reach");
  QTest::addColumn<int>("level");
  QTest::newRow("within the margin") << 9.9e-3 << int(Level::valid);
  QTest::newRow("beyond it") << 10.1e-3 << int(Level::degraded);
  QTest::newRow("says too little") << 30.1e-3 << int(Level::withdrawn);
}

void LesionJudgeTest::TheRegistrationsErrorDecidesAtTheStart() {
  QFETCH(double, reach);
  QFETCH(int, level);
  const Registration registration = start(round_spread(reach));
  LesionJudge judge(model_, registration);
  const Points tracked = points_at(registration.nodes_in_camera, 0.0);
  for (const auto& verdicts :
       {judge.at_start(Validity::valid), judge.judge(frame(registration.nodes_in_camera, 0), tracked)}) {
    QCOMPARE(verdicts.size(), std::size_t{1});
    QCOMPARE(int(verdicts[0].level), level);
    QVERIFY(std::abs(verdicts[0].reach - reach) < 1e-6);
    // The mean length of an isotropic normal vector in space.
    // The mean length of Student's distribution of three degrees of freedom over its 95th percentile.
    const double share = std::sqrt(8.0 / M_PI) * 1.381977 / std::sqrt(27.82988);
    QVERIFY(std::abs(verdicts[0].expected - share * reach) < 1e-6);
    QVERIFY(std::abs(verdicts[0].radius - 5e-3) < 1e-9);
    QVERIFY(verdicts[0].reason ==
            (level == int(Level::valid) ? LesionReason::known : LesionReason::start_uncertain));
  }
}

void LesionJudgeTest::AnUnknownErrorIsWithdrawn() {
  Registration registration = start(round_spread(1e-3));
  registration.lesions[0].lesion = structure::kFirstLesion + 1;
  LesionJudge judge(model_, registration);
  const auto verdicts =
      judge.judge(frame(registration.nodes_in_camera, 0), points_at(registration.nodes_in_camera, 0.0));
  QCOMPARE(verdicts.size(), std::size_t{1});
  QVERIFY(verdicts[0].level == Level::withdrawn);
  QVERIFY(verdicts[0].reason == LesionReason::error_unknown);
}

void LesionJudgeTest::TheSpreadTurnsWithTheOrgan() {
  const Eigen::Vector3d variances(1e-6, 4e-6, 9e-6);
  const Registration registration = start(variances.asDiagonal());
  LesionJudge judge(model_, registration);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  const Points turned = registration.nodes_in_camera * turn.transpose();
  const auto verdicts = judge.judge(frame(turned, 1), points_at(turned, 0.0));
  const Eigen::Matrix3d expected = Eigen::Vector3d(4e-6, 1e-6, 9e-6).asDiagonal();
  QVERIFY(verdicts[0].covariance.isApprox(expected, 1e-6));
  const Eigen::Vector3d centre = turn * (lesion_ + Eigen::Vector3d(0.0, 0.0, 0.15));
  QVERIFY((verdicts[0].centre - centre).norm() < 1e-9);
  QVERIFY(verdicts[0].level == Level::valid);
}

void LesionJudgeTest::PointsFarFromABentOrganSayLittle() {
  const Registration registration = start(round_spread(5e-3));
  Points bent = registration.nodes_in_camera;
  const Eigen::RowVector3d middle = bent.colwise().mean();
  // A saddle: no rigid motion is in it.
  for (Eigen::Index i = 0; i < bent.rows(); ++i)
    bent(i, 2) += 12.0 * (bent(i, 0) - middle[0]) * (bent(i, 1) - middle[1]);
  for (const double distance : {0.0, 60e-3}) {
    LesionJudge judge(model_, registration);
    std::vector<LesionVerdict> verdicts;
    for (int k = 0; k < 3; ++k) verdicts = judge.judge(frame(bent, k), points_at(bent, distance));
    QVERIFY(std::abs(verdicts[0].support - distance) < 1e-9);
    if (distance == 0.0) {
      QVERIFY(verdicts[0].level == Level::valid);
      QVERIFY(std::abs(verdicts[0].reach - 5e-3) < 2e-4);
      continue;
    }
    QVERIFY(verdicts[0].level != Level::valid);
    QVERIFY(verdicts[0].reason == LesionReason::far_from_points);
  }
}

void LesionJudgeTest::WhatIsUnseenIsKnownLessAndLess() {
  LesionOptions options;
  const double at_start = 7e-3, distance = 50e-3;
  const Registration registration = start(round_spread(at_start));
  LesionJudge judge(model_, registration, options);
  const Points& nodes = registration.nodes_in_camera;
  judge.judge(frame(nodes, 0), points_at(nodes, 0.0));
  const Points far_points = points_at(nodes, distance);
  const double far = 1.0 - std::exp(-std::pow(distance / options.reach, 2));
  double last = 0.0;
  LesionReason reason = LesionReason::known;
  for (int k = 1; k <= 300; ++k) {
    const LesionVerdict verdict = judge.judge(frame(nodes, k), far_points)[0];
    const double time = k / 30.0, free = std::pow(options.unknown_forces, 2);
    const double added = far * free * (1.0 - std::exp(-time / options.settle));
    const double expected = std::sqrt(at_start * at_start + kChi * added / 3.0);
    QVERIFY(std::abs(verdict.unseen - time) < 1e-9);
    QVERIFY2(std::abs(verdict.reach - expected) < 1e-6, qPrintable(QString::number(verdict.reach)));
    QVERIFY(verdict.reach > last);
    last = verdict.reach;
    reason = verdict.reason;
  }
  // With this limit of 4 mm it stays within the margin; a registration that knew less does not.
  QVERIFY(reason == LesionReason::known);
  LesionJudge worse(model_, start(round_spread(8.5e-3)), options);
  worse.judge(frame(nodes, 0), points_at(nodes, 0.0));
  LesionVerdict verdict;
  for (int k = 1; k <= 300; ++k) verdict = worse.judge(frame(nodes, k), far_points)[0];
  QVERIFY(verdict.level == Level::degraded);
  QVERIFY(verdict.reason == LesionReason::long_unseen);
}

void LesionJudgeTest::ASourceWithoutTimesLeavesNothingKnown_data() {
  QTest::addColumn<bool>("stands");
  QTest::newRow("its time stands") << true;
  QTest::newRow("its time goes back") << false;
}

void LesionJudgeTest::ASourceWithoutTimesLeavesNothingKnown() {
  // A frame counts as 1/30 s, as everywhere in guidance.
  QFETCH(bool, stands);
  const Registration registration = start(round_spread(7e-3));
  LesionJudge judge(model_, registration);
  const Points& nodes = registration.nodes_in_camera;
  const auto at = [&](int k, double seconds) {
    OverlayFrame overlay = frame(nodes, k);
    overlay.seconds = seconds;
    return overlay;
  };
  judge.judge(at(0, 100.0), points_at(nodes, 0.0));
  LesionVerdict verdict;
  for (int k = 1; k <= 90; ++k)
    verdict = judge.judge(at(k, stands ? 100.0 : 100.0 - k), points_at(nodes, 50e-3))[0];
  QVERIFY2(std::abs(verdict.unseen - 3.0) < 1e-6, qPrintable(QString::number(verdict.unseen)));
  QVERIFY(verdict.reach > 7.05e-3);
  // A correction shows the last frame once more: no time has passed.
  verdict = judge.judge(at(90, stands ? 100.0 : 10.0), points_at(nodes, 50e-3))[0];
  QVERIFY2(std::abs(verdict.unseen - 3.0) < 1e-6, qPrintable(QString::number(verdict.unseen)));
}

void LesionJudgeTest::WhatIsUnseenStaysSoWhenARegistrationIsTaken() {
  const Registration registration = start(round_spread(8.5e-3));
  LesionJudge judge(model_, registration);
  const Points& nodes = registration.nodes_in_camera;
  judge.judge(frame(nodes, 0), points_at(nodes, 0.0));
  const Points far_points = points_at(nodes, 50e-3);
  LesionVerdict before;
  int k = 1;
  for (; k <= 300; ++k) before = judge.judge(frame(nodes, k), far_points)[0];
  QVERIFY(before.level == Level::degraded && before.reason == LesionReason::long_unseen);
  for (int times = 0; times < 2; ++times) {  // and back
    judge.take(registration);
    for (int n = 0; n < 10; ++n, ++k) {
      const LesionVerdict after = judge.judge(frame(nodes, k), far_points)[0];
      QVERIFY2(after.unseen >= before.unseen, qPrintable(QString::number(after.unseen)));
      QVERIFY2(after.reach >= before.reach - 1e-9, qPrintable(QString::number(after.reach)));
      QVERIFY(after.level == Level::degraded && after.reason == LesionReason::long_unseen);
    }
  }
  for (int n = 0; n < 3; ++n, ++k) before = judge.judge(frame(nodes, k), points_at(nodes, 0.0))[0];
  QCOMPARE(before.unseen, 0.0);
}

void LesionJudgeTest::ATakenRegistrationSaysHowFarItsLesionsAreKnown() {
  const Registration worse = start(round_spread(12e-3)), better = start(round_spread(5e-3));
  LesionJudge judge(model_, worse);
  const Points& nodes = worse.nodes_in_camera;
  const Points near_points = points_at(nodes, 0.0);
  QVERIFY(judge.judge(frame(nodes, 0), near_points)[0].level == Level::degraded);
  judge.take(better);
  QVERIFY(judge.judge(frame(nodes, 1), near_points)[0].level == Level::valid);  // at once
  judge.take(worse);
  QVERIFY(judge.judge(frame(nodes, 2), near_points)[0].level == Level::degraded);
  Registration refused = better;
  refused.doubts = {"refusal_accepted"};
  judge.take(refused);
  QVERIFY(judge.judge(frame(nodes, 3), near_points)[0].reason == LesionReason::refused_start);
}

void LesionJudgeTest::NearPointsMakeItKnownAgain() {
  LesionOptions options;
  options.unknown_forces = 6e-3;
  const Registration registration = start(round_spread(7.5e-3));
  LesionJudge judge(model_, registration, options);
  const Points& nodes = registration.nodes_in_camera;
  LesionVerdict verdict;
  judge.judge(frame(nodes, 0), points_at(nodes, 1e-3));
  int k = 1;
  for (; k < 300; ++k) verdict = judge.judge(frame(nodes, k), points_at(nodes, 50e-3))[0];
  QVERIFY(verdict.level == Level::degraded);
  for (; k < 303; ++k) verdict = judge.judge(frame(nodes, k), points_at(nodes, 1e-3))[0];
  QVERIFY(verdict.level == Level::valid);
  QCOMPARE(verdict.unseen, 0.0);
  // No point at all: what was near stays what it was, and its time runs.
  for (; k < 333; ++k) verdict = judge.judge(frame(nodes, k), {})[0];
  QVERIFY(std::abs(verdict.unseen - 1.0) < 0.05);
}

void LesionJudgeTest::WhatWasOutOfSightAtFirstIsNotCountedTwice() {
  const Registration registration = start(round_spread(9e-3));
  LesionJudge judge(model_, registration);
  const Points& nodes = registration.nodes_in_camera;
  LesionVerdict verdict;
  for (int k = 0; k < 300; ++k) verdict = judge.judge(frame(nodes, k), points_at(nodes, 50e-3))[0];
  QVERIFY(verdict.level == Level::valid);
  QCOMPARE(verdict.unseen, 0.0);
  QVERIFY(std::abs(verdict.reach - 9e-3) < 1e-6);
}

void LesionJudgeTest::TheWholeIsNeverBetterThanItsLesions() {
  const Registration registration = start(round_spread(5e-3));
  LesionJudge judge(model_, registration);
  OverlayFrame overlay = frame(registration.nodes_in_camera, 0);
  for (const Validity validity : kValidities) {
    overlay.validity = validity;
    const LesionVerdict verdict = judge.judge(overlay, points_at(registration.nodes_in_camera, 0.0))[0];
    QVERIFY(verdict.level == level_of(validity));
    QVERIFY(judge.at_start(validity)[0].level == level_of(validity));
    if (validity != Validity::valid) QVERIFY(verdict.reason == LesionReason::with_the_whole);
  }
}

void LesionJudgeTest::ARefusedStartIsNeverValid() {
  Registration registration = start(round_spread(5e-3));
  for (const char* doubt : {"refused", "refusal_accepted"}) {
    registration.doubts = {doubt};
    const LesionVerdict verdict = LesionJudge(model_, registration).at_start(Validity::valid)[0];
    QVERIFY(verdict.level == Level::degraded);
    QVERIFY(verdict.reason == LesionReason::refused_start);
  }
}

void LesionJudgeTest::OneFrameChangesNothing() {
  LesionOptions options;
  options.unknown_forces = 0.0;
  const Registration registration = start(round_spread(9e-3));
  Points bent = registration.nodes_in_camera;
  for (Eigen::Index i = 0; i < bent.rows(); ++i) bent(i, 2) += 12.0 * bent(i, 0) * bent(i, 1);
  LesionJudge judge(model_, registration, options);
  for (int k = 0; k < 40; ++k) {
    const Points& nodes = k % 4 == 1 ? bent : registration.nodes_in_camera;
    QVERIFY(judge.judge(frame(nodes, k), points_at(nodes, 80e-3))[0].level == Level::valid);
  }
}

void LesionJudgeTest::UnusableOptionsAreRefused() {
  const Registration registration = start(round_spread(5e-3));
  const auto refused = [&](auto member, double value) {
    LesionOptions options;
    options.*member = value;
    try {
      LesionJudge(model_, registration, options);
    } catch (const InputError&) {
      return true;
    }
    return false;
  };
  QVERIFY(refused(&LesionOptions::margin, 0.0));
  QVERIFY(refused(&LesionOptions::useless, 1e-3));
  QVERIFY(refused(&LesionOptions::unknown_forces, -1.0));
  QVERIFY(refused(&LesionOptions::reach, 0.0));
  QVERIFY(refused(&LesionOptions::settle, 0.0));
  QVERIFY(refused(&LesionOptions::relief, 1.5));
  QVERIFY(!refused(&LesionOptions::margin, 8e-3));
}

QTEST_APPLESS_MAIN(LesionJudgeTest)
#include "lesion_judge_test.moc"
